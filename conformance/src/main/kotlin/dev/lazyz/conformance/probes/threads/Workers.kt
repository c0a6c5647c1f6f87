package dev.lazyz.conformance.probes.threads

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.probes.Question

/**
 * A frame whose primitives know whether they are queried by the thread that called the renderer, or by a worker, that
 * is, one of the renderer's own threads. The caller waits briefly for the first worker, so that the workers take part
 * if the renderer has any.
 *
 * @param caller the thread that calls the renderer
 * @param onCaller called in the caller before it gets an answer, once the first worker has made a query
 * @param onWorker called in a worker before it gets an answer
 */
internal class Workers(
    private val caller: Thread,
    private val onCaller: () -> Unit = {},
    private val onWorker: (Question) -> Unit,
) {
    /** Primitives that cover all samples, with more than four tiles of 8 samples for each of four threads. */
    val frame: Frame = Frame(Raster(SIDE, SIDE), List(COUNT) { Member(it) })

    /** Whether a worker has made a query. */
    @Volatile
    var hasWorker: Boolean = false
        private set

    @Volatile
    private var hasWaited = false

    private fun onQuery(question: Question) {
        if (Thread.currentThread() !== caller) {
            hasWorker = true
            onWorker(question)
        } else if (!hasWorker && !hasWaited) {
            awaitUntil(PATIENCE) { hasWorker }
            hasWaited = true
        }
        if (hasWorker && Thread.currentThread() === caller) onCaller()
    }

    private inner class Member(private val index: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = SIDE
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = SIDE

        override fun spans(y: Int, spans: Spans) {
            onQuery(Question.SPANS)
            spans.add(0, SIDE)
        }

        override fun depth(x: Int, y: Int): Int {
            onQuery(Question.DEPTH)
            return 1 + (x + y + index) % COUNT
        }

        override fun shade(fragment: Fragment) {
            onQuery(Question.COLOUR)
            fragment.setColor(index / COUNT.toFloat(), 0.5f, fragment.x / SIDE.toFloat())
        }
    }

    companion object {
        private const val SIDE = 64
        private const val COUNT = 4

        /** Nanoseconds that the caller waits for a worker, once. */
        private const val PATIENCE = 80_000_000L

        /** Returns the frame with primitives that do not distinguish threads. */
        fun quiet(): FrameCase =
            FrameCase(Workers(Thread.currentThread()) {}.frame, "SuiteFrames.workers()")
    }
}

/**
 * Waits until [condition] is true, or for this number of nanoseconds. It does not sleep: the thread may have been
 * interrupted, and other threads watch whether it is waiting.
 */
internal fun awaitUntil(nanoseconds: Long, condition: () -> Boolean) {
    val start = System.nanoTime()
    while (!condition() && System.nanoTime() - start < nanoseconds) Thread.yield()
}
