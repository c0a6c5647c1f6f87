package dev.lazyz.conformance.strangers

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink

/** Bands of rows and their counters, where several threads draw. */
internal val workerMistakes: List<Stranger> = listOf(
    Stranger(
        "bands-shared-keys",
        "all workers draw into the keys of one buffer; shows with several threads",
        setOf("7.5"),
    ) {
        bands { frame, options -> SharedKeys(frame, options) }
    },
    Stranger(
        "bands-suspensions-by-threads",
        "peak suspensions are multiplied by the threads; counters depend on their number",
        setOf("7.6"),
    ) {
        bands { frame, options ->
            object : BandDrawing(frame, options) {
                override fun run(sink: RowSink): Counters =
                    super.run(sink).toBuilder().apply { peakSuspensions *= threads }.build()
            }
        }
    },
)

/** Draws a band like [SweepDrawing], into [keys] that the caller has. */
private class SharedKeys(frame: Frame, options: RenderOptions) : BandDrawing(frame, options) {
    private val shared = LongArray(width)

    override fun worker(part: Frame): Drawing = object : SweepDrawing(part, Coherence.DIRECT) {
        override val keys: LongArray get() = shared
    }
}
