package dev.lazyz.tiled

import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** Passed often by whoever renders; throws if there is no point in going on. */
internal fun interface Checkpoint {
    fun pass()
}

/**
 * Which tile is next, and whether to go on: what the threads of a rendering share.
 *
 * Tiles are numbered band by band. A counter gives each to one thread, as soon as its band has been filled. Thread
 * safe.
 */
internal class Schedule : Checkpoint {
    private val next = AtomicLong()

    /** Tiles below this one may be taken. */
    @Volatile
    private var available = 0L

    @Volatile
    private var isOver = false
    private val failure = AtomicReference<Throwable>()
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    /** What went wrong first, or null. */
    val firstFailure: Throwable? get() = failure.get()

    /** Lets tiles up to [end] be taken. */
    fun release(end: Long) {
        available = end
        signal()
    }

    /** Returns the next tile, or [NONE] if none is available now. */
    fun take(): Long {
        while (true) {
            val tile = next.get()
            if (tile >= available) return NONE
            if (next.compareAndSet(tile, tile + 1)) return tile
        }
    }

    /** Returns the next tile once it is available, or [NONE] when the rendering is over. */
    fun takeOrWait(): Long {
        while (!isOver) {
            val tile = take()
            if (tile != NONE) return tile
            awaitUntil { next.get() < available }
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
