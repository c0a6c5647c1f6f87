package dev.lazyz.conformance.probes.threads

import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.probes.answer
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport

/** Fails if threads of [renderer]'s own ask primitives when a rendering has ended that failed on the caller's thread. */
internal fun nobodyAsksAfterTheEnd(renderer: Renderer) {
    for (isSinkToFail in listOf(false, true)) {
        val late = LateQuestions(renderer, isSinkToFail).count() ?: return
        if (late == 0) continue
        val what = if (isSinkToFail) "the sink" else "a primitive"
        Judgement(renderer, Workers.quiet(), "$what that throws")
            .fail("when the rendering had ended, threads of its own asked primitives $late times")
    }
}

/** A rendering that fails on the caller's thread while workers are at work, who are slow. */
private class LateQuestions(private val renderer: Renderer, private val isSinkToFail: Boolean) {
    private val planted = IllegalStateException("planted")
    private val pauses = AtomicInteger()
    private val late = AtomicInteger()

    @Volatile
    private var hasEnded = false

    /** Returns how many questions came late; null if there are no workers. */
    fun count(): Int? {
        val workers = Workers(Thread.currentThread(), { if (!isSinkToFail) throw planted }) { beSlow() }
        val sink = RowSink { _, _, _, _ -> if (isSinkToFail) throw planted }
        answer { renderer.render(workers.frame, sink) }
        hasEnded = true
        if (!workers.hasCome) return null
        Thread.sleep(PATIENCE)
        return late.get()
    }

    private fun beSlow() {
        if (hasEnded) late.incrementAndGet()
        if (pauses.getAndIncrement() < MOST_PAUSES) LockSupport.parkNanos(PAUSE)
    }

    private companion object {
        /** How many answers are slow: those of a tile, more or less. */
        const val MOST_PAUSES = 300

        /** Nanoseconds. */
        const val PAUSE = 500_000L

        /** Milliseconds in which a thread asks again. */
        const val PATIENCE = 40L
    }
}
