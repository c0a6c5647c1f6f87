package dev.lazyz.strategies.tiled

import dev.lazyz.strategies.tiled.raster.Checkpoint
import java.util.concurrent.atomic.AtomicLongArray
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Which tile is next, and whether to go on: what the threads of a rendering share.
 *
 * Tiles are numbered band by band. Each thread has a stretch of columns, whose tiles it takes as soon as their band has been
 * filled, and band after band: the rows' memory stays in its cache. Who has nothing left takes from the others' stretches.
 * Thread safe.
 *
 * Source: Robert D. Blumofe, Charles E. Leiserson, "Scheduling Multithreaded Computations by Work Stealing", Journal of
 * the ACM 46 (1999); here with a counter for each stretch in place of a queue.
 *
 * @param columns tiles in a band
 * @param threads number of threads
 */
internal class Schedule(private val columns: Int, threads: Int) : Checkpoint {
    private val stretches = minOf(threads, columns)

    /** Number of tiles of each stretch that have been taken. */
    private val taken = AtomicLongArray(stretches)

    /** Tiles of bands below this one may be taken. */
    @Volatile
    private var filled = 0

    @Volatile
    private var isOver = false
    private val failure = AtomicReference<Throwable>()
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    /** What went wrong first, or null. */
    val firstFailure: Throwable? get() = failure.get()

    /** Lets the tiles of bands up to [end] be taken. */
    fun release(end: Int) {
        filled = end
        signal()
    }

    /** Returns the next tile for thread number [thread], or [NONE] if none is available now. */
    fun take(thread: Int): Long {
        for (i in 0 until stretches) {
            val tile = takeOf((thread + i) % stretches)
            if (tile != NONE) return tile
        }
        return NONE
    }

    private fun takeOf(stretch: Int): Long {
        val start = start(stretch)
        val width = start(stretch + 1) - start
        while (true) {
            val tile = taken.get(stretch)
            if (tile >= filled * width) return NONE
            if (taken.compareAndSet(stretch, tile, tile + 1)) return tile / width * columns + start + tile % width
        }
    }

    /** First column of a stretch. */
    private fun start(stretch: Int): Long = columns.toLong() * stretch / stretches

    private fun hasTiles(): Boolean {
        for (stretch in 0 until stretches) {
            if (taken.get(stretch) < filled * (start(stretch + 1) - start(stretch))) return true
        }
        return false
    }

    /** Returns the next tile for thread number [thread] once it is available, or [NONE] when the rendering is over. */
    fun takeOrWait(thread: Int): Long {
        while (!isOver) {
            val tile = take(thread)
            if (tile != NONE) return tile
            awaitUntil(::hasTiles)
        }
        return NONE
    }

    /**
     * Waits until [condition] holds, which has to be signalled, or the rendering is over. At first without sleep: a tile
     * takes less time than to be woken up.
     */
    fun awaitUntil(condition: () -> Boolean) {
        for (spin in 0 until SPINS) {
            if (isOver || condition()) return
            Thread.onSpinWait()
        }
        lock.withLock { while (!isOver && !condition()) changed.await() }
    }

    /** Tells those who wait to look again. */
    fun signal() {
        lock.withLock { changed.signalAll() }
    }

    /** Ends the rendering: nobody waits any longer, and whoever passes a checkpoint gives up. */
    fun end() {
        isOver = true
        signal()
    }

    /** Ends the rendering because of [cause]. */
    fun fail(cause: Throwable) {
        if (cause !== Abandoned && !failure.compareAndSet(null, cause)) {
            // A thread that was interrupted is no second cause: it was told to end
            val first = failure.get()
            if (cause !== first && cause !is InterruptedException) first.addSuppressed(cause)
        }
        end()
    }

    /** Throws [Abandoned] if the rendering is over. */
    override fun pass() {
        if (isOver) throw Abandoned
    }

    /** Ends the work of a thread whose rendering is over; nobody else gets to see it. */
    private object Abandoned : RuntimeException(null, null, false, false) {
        private fun readResolve(): Any = Abandoned
    }

    companion object {
        /** Looks at a condition before falling asleep: some 20 microseconds. */
        private const val SPINS = 500

        /** No tile. */
        const val NONE: Long = -1
    }
}
