package dev.lazyz

import java.io.IOException
import java.io.InterruptedIOException
import java.io.UncheckedIOException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.runInterruptible

/**
 * The rows of a picture as an iterator, from the top, by any [Renderer]. The reader pulls them one by one, and the
 * rendering waits for it, so a picture can be larger than memory. In Kotlin:
 *
 * ```
 * RenderedRows.of(renderer, frame).use { rows -> for (row in rows) consume(row.argb) }
 * ```
 *
 * In Java:
 *
 * ```java
 * try (RenderedRows rows = RenderedRows.of(renderer, frame)) {
 *     while (rows.hasNext()) {
 *         consume(rows.next().getArgb());
 *     }
 * }
 * ```
 *
 * The rendering has a thread of its own, a daemon, which begins with the first call of [hasNext] or [next]. It is at
 * most two rows ahead of the reader: one that waits, and one that it has just computed. Memory: that of the renderer,
 * and 12 bytes a column for each of them. An exception of the rendering reaches the reader after the rows before it,
 * unchanged, except that an [IOException] is the cause of an [UncheckedIOException], and an [InterruptedException] that
 * of an [InterruptedIOException] in it. An iterator cannot declare them.
 *
 * In Kotlin, [asSequence] makes a `Sequence` of it, to be read once, and [flow] a `Flow`.
 *
 * Always [close] it: this stops the rendering if it is not complete, and waits until its threads have stopped. A
 * renderer that does not check for interrupts stops at its next row. Used by one thread at a time.
 */
public class RenderedRows internal constructor(private val width: Int, private val render: (RowSink) -> Counters) :
    Iterator<RenderedRows.Row>,
    AutoCloseable {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    /** The row that waits for the reader. All that follows is guarded by the lock. */
    private var row: RenderedRows.Row? = null
    private var state = State.NEW
    private var thread: Thread? = null
    private var failure: Throwable? = null
    private var result: Counters? = null
    private var isClosed = false

    /**
     * The work of the rendering.
     *
     * @throws IllegalStateException if it is not complete: it is when [hasNext] has returned false
     */
    public val counters: Counters
        get() = lock.withLock { checkNotNull(result) { "the rendering is not complete" } }

    /**
     * Returns whether there is another row. Waits until it is rendered, or the rendering is complete.
     *
     * @throws UncheckedIOException if the renderer throws an [IOException] or an [InterruptedException]; or if the
     *   calling thread is interrupted while it waits: then the cause is an [InterruptedIOException], and the interrupt
     *   status is set
     * @throws IllegalStateException if this is closed
     */
    override fun hasNext(): Boolean = try {
        awaitNext()
    } catch (e: InterruptedException) {
        Thread.currentThread().interrupt()
        throw unchecked(e)
    }

    /** Does what [hasNext] does, but throws an [InterruptedException] if the calling thread is interrupted. */
    private fun awaitNext(): Boolean = lock.withLock {
        begin()
        while (row == null && state == State.RUNNING && !isClosed) changed.await()
        check(!isClosed) { "the rows are closed" }
        if (row == null) failure?.let { throw it }
        row != null
    }

    /**
     * Returns the next row. Waits and throws like [hasNext].
     *
     * @throws NoSuchElementException if there is none
     */
    override fun next(): RenderedRows.Row {
        if (!hasNext()) throw NoSuchElementException("there are no more rows")
        return lock.withLock {
            val next = checkNotNull(row)
            row = null
            changed.signalAll()
            next
        }
    }

    /** Stops the rendering, and waits until its threads have stopped. Closing again does nothing. */
    override fun close(): Unit = lock.withLock {
        isClosed = true
        row = null
        changed.signalAll()
        thread?.interrupt()
        while (state == State.RUNNING) changed.awaitUninterruptibly()
    }

    private fun begin() {
        if (state != State.NEW || isClosed) return
        LibraryThreads.execute(::run)
        state = State.RUNNING
    }

    /** The work of the rendering's thread. */
    private fun run() {
        var counters: Counters? = null
        var thrown: Throwable? = null
        try {
            lock.withLock {
                if (isClosed) return
                thread = Thread.currentThread()
            }
            counters = render { y, argb, depth, primitive ->
                put(RenderedRows.Row(y, argb.copyOf(width), depth.copyOf(width), primitive.copyOf(width)))
            }
        } catch (e: Throwable) {
            thrown = e
        } finally {
            lock.withLock {
                thread = null
                result = counters
                failure = thrown?.let(::unchecked)
                state = State.OVER
                changed.signalAll()

                // The interrupt was meant for this work, and not for the next task of the thread
                Thread.interrupted()
            }
        }
    }

    private fun put(next: RenderedRows.Row) = lock.withLock {
        while (row != null && !isClosed) changed.await()
        if (isClosed) throw InterruptedException("the reader has closed the rows")
        row = next
        changed.signalAll()
    }

    /** Returns [e], or if Java would not let readers catch it, an exception with it as cause. */
    private fun unchecked(e: Throwable): Throwable = when (e) {
        is IOException -> UncheckedIOException(e)
        is InterruptedException -> UncheckedIOException(InterruptedIOException(e.message).apply { initCause(e) })
        else -> e
    }

    private enum class State { NEW, RUNNING, OVER }

    /**
     * A finished row of a picture. Its arrays belong to the reader, who may keep and change them.
     *
     * Any renderer makes such rows, see [RenderedRows]. `Row` of the package `pipeline` is a row of `LazyRenderer` and
     * `FlowRenderer` whose colours are not computed yet, and which refers to the frame.
     *
     * @property y the number of the row in the raster
     * @property argb colours, 8-bit sRGB with straight alpha, `0xAARRGGBB`; element 0 is the first column of the region
     * @property depth depths, 0..2^31-1, see [Depth]
     * @property primitive submission index of the visible primitive, or [DepthTest.BACKGROUND]
     */
    public class Row internal constructor(
        public val y: Int,
        public val argb: IntArray,
        public val depth: IntArray,
        public val primitive: IntArray,
    ) {
        override fun toString(): String = "Row($y, ${argb.size} columns)"
    }

    public companion object {
        /** Returns the rows that [renderer] computes of [frame]. */
        @JvmStatic
        public fun of(renderer: Renderer, frame: Frame): RenderedRows =
            RenderedRows(frame.width) { renderer.render(frame, it) }

        /**
         * Returns a flow of the rows that [open] returns, which are rendered anew for each collection. A slow collector
         * holds the rendering back; if its coroutine is cancelled or fails, the rendering stops.
         *
         * The collector's thread is blocked while it waits for a row: use [kotlinx.coroutines.flow.flowOn] with
         * [kotlinx.coroutines.Dispatchers.IO].
         */
        @JvmSynthetic
        public fun flow(open: () -> RenderedRows): Flow<RenderedRows.Row> = kotlinx.coroutines.flow.flow {
            open().use { rows -> while (runInterruptible { rows.awaitNext() }) emit(rows.next()) }
        }
    }
}
