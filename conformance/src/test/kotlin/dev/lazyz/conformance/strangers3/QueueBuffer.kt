package dev.lazyz.conformance.strangers3

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import java.util.concurrent.atomic.AtomicReference

/** A depth buffer whose colours wait in a queue; the queue has the budget's length and is drained when full. */
internal class QueueBuffer(options: RenderOptions = RenderOptions(), mistake: Mistake? = null) :
    Third("queue", options, mistake) {
    private val kept = AtomicReference<QueueSamples?>()

    override val capabilities: Set<Capability>
        get() = setOf(Capability.STREAMS_PRIMITIVES, Capability.MEMORY_BUDGET)

    override fun configured(options: RenderOptions): Renderer = QueueBuffer(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuseTranslucent(frame)
        val counters = Counters.Builder()
        val samples = samples(frame)
        try {
            samples.begin(frame, counters)
            run(frame, samples, counters, sink)
        } finally {
            samples.end()
        }
        return counters.build()
    }

    private fun run(frame: Frame, samples: QueueSamples, counters: Counters.Builder, sink: RowSink) {
        val seen = ArrayList<Primitive>()
        var index = 0
        for (primitive in frame.primitives) {
            counters.primitives++
            if (mistake == Mistake.QUEUE_KEEPS_PRIMITIVES) seen += primitive
            samples.draw(primitive, index++)
        }
        counters.peakBytes += 8L * seen.size
        samples.handOut(sink)
    }

    private fun samples(frame: Frame): QueueSamples {
        require(frame.region.size <= Int.MAX_VALUE - 8L) { "too many samples: ${frame.region.size}" }
        val size = frame.region.size.toInt()
        if (mistake == Mistake.QUEUE_SHARED_BUFFERS || mistake == Mistake.QUEUE_CLEANS_AFTER) {
            val old = kept.get()
            if (old != null && old.size == size) return old
        }
        val made = QueueSamples(size, capacity(frame), mistake)
        if (mistake == Mistake.QUEUE_SHARED_BUFFERS || mistake == Mistake.QUEUE_CLEANS_AFTER) kept.set(made)
        return made
    }

    /** Entries that the queue may have. */
    private fun capacity(frame: Frame): Int {
        val most = minOf(MOST, frame.region.size)
        val budget = options.memoryBudget ?: return most.toInt()
        if (mistake == Mistake.QUEUE_BUDGET_INT) return minOf((budget / ENTRY_BYTES).toInt(), most.toInt())
        val entries = minOf(budget / ENTRY_BYTES, most).toInt()
        return when (mistake) {
            Mistake.QUEUE_BUDGET_ROUNDED -> if (entries <= 1) entries else (entries - 1).takeHighestOneBit() * 2
            Mistake.QUEUE_BUDGET_LEAST -> maxOf(entries, 16)
            else -> entries
        }
    }

    private companion object {
        const val MOST = 1L shl 16
        const val ENTRY_BYTES = 8L
    }
}
