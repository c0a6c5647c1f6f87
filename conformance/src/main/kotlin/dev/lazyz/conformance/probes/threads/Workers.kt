package dev.lazyz.conformance.probes.threads

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.probes.Question

/**
 * A frame whose primitives know whether the thread that rendering was asked of asks them, or a worker: a thread of the
 * renderer's own. The caller waits a little for the first worker, so that there is one if the renderer has any.
 *
 * @param caller the thread that calls the renderer
 * @param onCaller what the caller does before it gets an answer, after the first worker has come
 * @param onWorker what a worker does before it gets an answer
 */
internal class Workers(
    private val caller: Thread,
    private val onCaller: () -> Unit = {},
    private val onWorker: (Question) -> Unit,
) {
    /** Primitives that cover all samples, with four tiles of 8 samples for each of four threads and more. */
    val frame: Frame = Frame(Raster(SIDE, SIDE), List(COUNT) { Member(it) })

    /** Whether a worker has asked. */
    @Volatile
    var hasCome: Boolean = false
        private set

    @Volatile
    private var hasWaited = false

    private fun heed(question: Question) {
        if (Thread.currentThread() !== caller) {
            hasCome = true
            onWorker(question)
        } else if (!hasCome && !hasWaited) {
            // Awake, because the caller may have been interrupted, and must not be seen to sleep
            val start = System.nanoTime()
            while (!hasCome && System.nanoTime() - start < PATIENCE) Thread.yield()
            hasWaited = true
        }
        if (hasCome && Thread.currentThread() === caller) onCaller()
    }

    private inner class Member(private val index: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = SIDE
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = SIDE

        override fun spans(y: Int, spans: Spans) {
            heed(Question.SPANS)
            spans.add(0, SIDE)
        }

        override fun depth(x: Int, y: Int): Int {
            heed(Question.DEPTH)
            return 1 + (x + y + index) % COUNT
        }

        override fun shade(fragment: Fragment) {
            heed(Question.COLOUR)
            fragment.setColor(index / COUNT.toFloat(), 0.5f, fragment.x / SIDE.toFloat())
        }
    }

    companion object {
        private const val SIDE = 64
        private const val COUNT = 4

        /** Nanoseconds that the caller waits for a worker, once. */
        private const val PATIENCE = 80_000_000L

        /** The frame as it is when nobody heeds who asks. */
        fun quiet(): FrameCase =
            FrameCase(Workers(Thread.currentThread()) {}.frame, "// $COUNT primitives that cover $SIDE x $SIDE samples")
    }
}
