package dev.lazyz.strategies.tiled

import dev.lazyz.Checkpoint
import java.util.concurrent.atomic.AtomicLongArray
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.Condition
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The state that the threads of a rendering share: which tile is next, and whether to continue.
 *
 * Tiles are numbered band by band. Each thread has a range of columns. It takes the tiles of this range band after
 * band, as soon as each band is filled, so that the rows' memory stays in its cache. A thread whose range has no tiles
 * left takes tiles from the ranges of other threads. Thread safe.
 *
 * Source: Robert D. Blumofe, Charles E. Leiserson, "Scheduling Multithreaded Computations by Work Stealing", Journal of
 * the ACM 46 (1999); here with a counter for each range in place of a queue.
 *
 * @param columns tiles in a band
 * @param threads number of threads
 */
internal class Schedule(private val columns: Int, threads: Int) : Checkpoint {
    private val ranges = minOf(threads, columns)

    /** Number of tiles of each range that have been taken. */
    private val taken = AtomicLongArray(ranges)

    /** Tiles of bands below this one may be taken. */
    @Volatile
    private var filled = 0

    @Volatile
    private var isOver = false
    private val failure = AtomicReference<Throwable>()
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    /** The first failure, or null. */
    val firstFailure: Throwable? get() = failure.get()

    /** Allows tiles of the bands before [end] to be taken. */
    fun release(end: Int) {
        filled = end
        signal()
    }

    /** Returns the next tile for thread number [thread], or [NONE] if none is available now. */
    fun take(thread: Int): Long {
        for (i in 0 until ranges) {
            val tile = takeOf((thread + i) % ranges)
            if (tile != NONE) return tile
        }
        return NONE
    }

    private fun takeOf(range: Int): Long {
        val start = start(range)
        val width = start(range + 1) - start
        while (true) {
            val tile = taken.get(range)
            if (tile >= filled * width) return NONE
            if (taken.compareAndSet(range, tile, tile + 1)) return tile / width * columns + start + tile % width
        }
    }

    /** First column of a range. */
    private fun start(range: Int): Long = columns.toLong() * range / ranges

    private fun hasTiles(): Boolean {
        for (range in 0 until ranges) {
            if (taken.get(range) < filled * (start(range + 1) - start(range))) return true
        }
        return false
    }

    /**
     * Returns the next tile for thread number [thread] once it is available, or [NONE] when the rendering is over. For
     * the threads of an executor, whose interrupt status is not ours: it neither ends the wait nor the rendering.
     */
    fun takeOrWait(thread: Int): Long {
        while (!isOver) {
            val tile = take(thread)
            if (tile != NONE) return tile
            awaitUntil(::hasTiles, Condition::awaitUninterruptibly)
        }
        return NONE
    }

    /**
     * Waits until [condition] holds or the rendering is over. Changes of the condition must be signalled. Spins before
     * it sleeps, because a tile takes less time than waking a thread.
     *
     * @param sleep waits for a signal
     * @throws InterruptedException if the thread is interrupted, unless [sleep] is for threads of an executor
     */
    fun awaitUntil(condition: () -> Boolean, sleep: Condition.() -> Unit = Condition::await) {
        for (spin in 0 until SPINS) {
            if (isOver || condition()) return
            Thread.onSpinWait()
        }
        lock.withLock { while (!isOver && !condition()) changed.sleep() }
    }

    /** Makes waiting threads check their conditions again. */
    fun signal() {
        lock.withLock { changed.signalAll() }
    }

    /** Ends the rendering: threads stop waiting, and stop at their next checkpoint. */
    fun end() {
        isOver = true
        signal()
    }

    /** Ends the rendering because of [cause], the first of which reaches the caller. */
    fun fail(cause: Throwable) {
        if (cause !== Abandoned) failure.compareAndSet(null, cause)
        end()
    }

    /** Throws [Abandoned] if the rendering is over. */
    override fun pass() {
        if (isOver) throw Abandoned
    }

    /** Ends the work of a thread whose rendering is over; never leaves this package. */
    private object Abandoned : RuntimeException(null, null, false, false) {
        private fun readResolve(): Any = Abandoned
    }

    companion object {
        /** Number of checks of a condition before sleeping: about 20 microseconds. */
        private const val SPINS = 500

        /** No tile. */
        const val NONE: Long = -1
    }
}
