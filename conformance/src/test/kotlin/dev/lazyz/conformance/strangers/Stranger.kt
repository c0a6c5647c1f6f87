package dev.lazyz.conformance.strangers

import dev.lazyz.Renderer

/**
 * A renderer with one mistake, written without a look at the suite.
 *
 * @property what the mistake, and on which legal frames it shows
 * @property chapters the rules of the contract that the mistake is about
 */
internal class Stranger(val id: String, val what: String, val chapters: Set<String>, val make: () -> Renderer) {
    override fun toString(): String = id
}

/** All strangers, and the right renderers that they derive from. */
internal object StrangersGallery {
    val all: List<Stranger> =
        depthMistakes + tileMistakes + binMistakes + sweepMistakes + listMistakes + blendMistakes +
            shadingMistakes + stepMistakes + counterMistakes + workerMistakes + threadMistakes + regionMistakes +
            promiseMistakes + failureMistakes + largeMistakes

    val correct: List<() -> Renderer> = listOf(
        { plain { PlainDrawing(it) } },
        { nearToFar { NearToFarDrawing(it) } },
        { waiting { frame, options -> WaitingDrawing(frame, options) } },
        { tiles { frame, tileSize -> TileDrawing(frame, tileSize) } },
        { sweep { frame, coherence -> SweepDrawing(frame, coherence) } },
        { lists { frame, selector -> ListDrawing(frame, selector) } },
        { bands { frame, options -> BandDrawing(frame, options) } },
    )
}
