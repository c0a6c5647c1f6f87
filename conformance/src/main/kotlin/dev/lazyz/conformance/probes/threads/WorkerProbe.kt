package dev.lazyz.conformance.probes.threads

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.probes.Question
import dev.lazyz.conformance.probes.answer
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.lang.management.ManagementFactory
import java.util.EnumSet
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport

/**
 * A frame whose primitives know whether they are queried by the thread that called the renderer, or by a worker, that
 * is, one of the renderer's own threads. The caller waits briefly for the first worker, so that the workers take part
 * if the renderer has any. It does so once for each kind of question: in the step that asks the first, there may be
 * nothing to do for workers, and in the next a busy machine lets the caller do all before they begin.
 *
 * @param caller the thread that calls the renderer
 * @param onCaller called in the caller before it gets an answer, once the first worker has made a query
 * @param onWorker called in a worker before it gets an answer about row `y`
 */
internal class WorkerProbe(
    private val caller: Thread,
    private val onCaller: () -> Unit = {},
    private val onWorker: (Question, y: Int) -> Unit,
) {
    /** Primitives that cover all samples, with more than four tiles of 8 samples for each of four threads. */
    val frame: Frame = Frame(Raster(SIDE, SIDE), List(COUNT) { Member(it) })

    /** Whether a worker has made a query. */
    @Volatile
    var hasWorker: Boolean = false
        private set

    /** What the caller has been asked. */
    private val asked = EnumSet.noneOf(Question::class.java)

    private fun onQuery(question: Question, y: Int) {
        if (Thread.currentThread() !== caller) {
            hasWorker = true
            onWorker(question, y)
        } else if (!hasWorker && asked.add(question)) {
            awaitUntil(PATIENCE) { hasWorker }
        }
        if (hasWorker && Thread.currentThread() === caller) onCaller()
    }

    private inner class Member(private val index: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = SIDE
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = SIDE

        override fun spans(y: Int, spans: Spans) {
            onQuery(Question.SPANS, y)
            spans.add(0, SIDE)
        }

        override fun depth(x: Int, y: Int): Int {
            onQuery(Question.DEPTH, y)
            return 1 + (x + y + index) % COUNT
        }

        override fun shade(fragment: Fragment) {
            onQuery(Question.COLOUR, fragment.y)
            fragment.setColor(index / COUNT.toFloat(), 0.5f, fragment.x / SIDE.toFloat())
        }
    }

    companion object {
        private const val SIDE = 64
        private const val COUNT = 4

        /** Nanoseconds of its processor time that the caller waits for a worker. */
        private const val PATIENCE = 80_000_000L

        /** Returns the frame with primitives that do not distinguish threads. */
        fun quiet(): FrameCase = FrameCase(
            WorkerProbe(Thread.currentThread()) { _, _ ->
            }.frame,
            "SuiteFrames.workers()"
        )
    }
}

/**
 * Waits until [condition] is true, or the wait has used this number of nanoseconds of a processor, however long the
 * machine was busy with something else meanwhile. It does not sleep: the thread may have been interrupted, and other
 * threads watch whether it is waiting. Nor does it yield: where others are busy, a thread that yields hardly uses a
 * processor, and would wait for minutes.
 */
internal fun awaitUntil(nanoseconds: Long, condition: () -> Boolean) {
    val start = processorTime()
    while (!condition() && processorTime() - start < nanoseconds) Thread.onSpinWait()
}

/**
 * Returns the nanoseconds of a processor that this thread has used; the time on the wall where no JVM measures them.
 */
private fun processorTime(): Long =
    if (times.isCurrentThreadCpuTimeSupported) times.currentThreadCpuTime else System.nanoTime()

internal val times = ManagementFactory.getThreadMXBean()

/**
 * Fails if [renderer]'s own threads query primitives after a rendering has ended with a failure on the caller's thread.
 */
internal fun makesNoLateQueries(renderer: Renderer) {
    for (isSinkToFail in listOf(false, true)) {
        val late = LateQuestions(renderer, isSinkToFail).count() ?: return
        if (late == 0) continue
        val what = if (isSinkToFail) "the sink" else "a primitive"
        Judgement(renderer, WorkerProbe.quiet(), "$what that throws")
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
        val workers = WorkerProbe(Thread.currentThread(), { if (!isSinkToFail) throw planted }) { _, y -> delay(y) }
        val sink = RowSink { _, _, _, _ -> if (isSinkToFail) throw planted }
        answer { renderer.inTime(workers.frame, sink) }
        hasEnded = true
        if (!workers.hasWorker) return null
        Thread.sleep(PATIENCE)
        return late.get()
    }

    /** The first rows are not slow: while the sink gets them, others are still to be drawn. */
    private fun delay(y: Int) {
        if (hasEnded) late.incrementAndGet()
        if (y >= QUICK && pauses.getAndIncrement() < MOST_PAUSES) LockSupport.parkNanos(PAUSE)
    }

    private companion object {
        /** Number of rows without slow answers. */
        const val QUICK = 8

        /** Number of slow answers. */
        const val MOST_PAUSES = 300

        /** In nanoseconds. */
        const val PAUSE = 500_000L

        /** Milliseconds to wait for further queries. */
        const val PATIENCE = 40L
    }
}
