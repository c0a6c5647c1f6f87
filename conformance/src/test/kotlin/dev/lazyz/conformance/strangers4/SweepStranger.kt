package dev.lazyz.conformance.strangers4

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/** Row by row with an active list; along a row from event to event; colours in steps, once the row is decided. */
internal class SweepStranger(
    private val mistake: Mistake? = null,
    private val coherence: Coherence = Coherence.DIRECT,
) : Renderer {
    @Volatile
    private var last: Frame? = null

    override val id: String get() = "stranger-sweep"
    override val summary: String get() = "rows with an active list, runs between events decided by their ends"
    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Renderer {
        options.requireSupportedBy(this)
        // Direct is the default: nothing to change
        if (mistake == Mistake.SWEEP_DIRECT_IGNORED && options.coherence == Coherence.DIRECT) return this
        return SweepStranger(mistake, options.coherence)
    }

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuse(frame)
        if (mistake == Mistake.SWEEP_FRAME_KEPT) last = frame
        val counters = Counters.Builder()
        val list = SweepList(frame, mistake)
        val row = SweepRow(frame, counters, mistake)
        val shading = SweepShading(frame, coherence, counters, mistake)
        counters.primitives = (if (mistake == Mistake.SWEEP_COUNTS_REACHING) list.reaching else frame.primitives.size)
            .toLong()
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            if (Thread.currentThread().isInterrupted) {
                if (mistake == Mistake.SWEEP_STOPS_SILENTLY) break
                if (mistake != Mistake.SWEEP_STATUS_KEPT) Thread.interrupted()
                throw InterruptedException("interrupted before row $y")
            }
            list.moveTo(y)
            row.decide(y, list)
            shading.shade(y, row.indices)
            counters.peakBytes = maxOf(counters.peakBytes, list.bytes + row.bytes + shading.bytes)
            if (mistake == Mistake.SWEEP_ADMITS_EARLY) list.admit(y + 1)
            sink.row(y, shading.argb, row.depths, row.indices)
        }
        return counters.build()
    }

    private fun refuse(frame: Frame) {
        if (mistake == Mistake.SWEEP_REFUSAL_VAGUE && frame.hasTranslucency) {
            throw IllegalArgumentException("$id does not support transparency")
        }
        refuseTranslucent(frame)
    }

    override fun toString(): String = "SweepStranger($mistake, $coherence, ${last != null})"
}
