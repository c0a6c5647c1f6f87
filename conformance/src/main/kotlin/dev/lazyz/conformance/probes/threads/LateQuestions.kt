package dev.lazyz.conformance.probes.threads

import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.probes.answer
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport

/**
 * Fails if [renderer]'s own threads query primitives after a rendering has ended with a failure on the caller's thread.
 */
internal fun makesNoLateQueries(renderer: Renderer) {
    for (isSinkToFail in listOf(false, true)) {
        val late = LateQuestions(renderer, isSinkToFail).count() ?: return
        if (late == 0) continue
        val what = if (isSinkToFail) "the sink" else "a primitive"
        Judgement(renderer, Workers.quiet(), "$what that throws")
            .fail("after the rendering had ended, its threads queried primitives $late times")
    }
}

/** A rendering that fails on the caller's thread while worker threads run slowly. */
private class LateQuestions(private val renderer: Renderer, private val isSinkToFail: Boolean) {
    private val planted = IllegalStateException("planted")
    private val pauses = AtomicInteger()
    private val late = AtomicInteger()

    @Volatile
    private var hasEnded = false

    /** Returns the number of late queries; null if there are no workers. */
    fun count(): Int? {
        val workers = Workers(Thread.currentThread(), { if (!isSinkToFail) throw planted }) { delay() }
        val sink = RowSink { _, _, _, _ -> if (isSinkToFail) throw planted }
        answer { renderer.inTime(workers.frame, sink) }
        hasEnded = true
        if (!workers.hasWorker) return null
        Thread.sleep(PATIENCE)
        return late.get()
    }

    private fun delay() {
        if (hasEnded) late.incrementAndGet()
        if (pauses.getAndIncrement() < MOST_PAUSES) LockSupport.parkNanos(PAUSE)
    }

    private companion object {
        /** Number of slow answers: about as many as a tile needs. */
        const val MOST_PAUSES = 300

        /** In nanoseconds. */
        const val PAUSE = 500_000L

        /** Milliseconds to wait for further queries. */
        const val PATIENCE = 40L
    }
}
