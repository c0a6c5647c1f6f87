package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.Mistake

/** Right renderers, one for each way to work, whose steps a mistake overrides. */
internal object Skeletons {
    val correct: List<() -> Renderer> = listOf(
        { plain { PlainDrawing(it) } },
        { tiles { frame, tileSize -> TileDrawing(frame, tileSize) } },
        { sweep { frame, coherence -> SweepDrawing(frame, coherence) } },
        { lists { frame, selector -> ListDrawing(frame, selector) } },
        { bands { frame, options -> BandDrawing(frame, options) } },
    )

    val mistakes: List<Mistake> = depthMistakes + largeMistakes + tileMistakes + binMistakes + sweepMistakes +
        stepMistakes + listMistakes + blendMistakes + shadingMistakes + regionMistakes + counterMistakes +
        workerMistakes + threadMistakes + failureMistakes
}
