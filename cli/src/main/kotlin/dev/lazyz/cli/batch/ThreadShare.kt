package dev.lazyz.cli.batch

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Shares [total] threads among the inputs that are rendered at the same time: one for each input, and those that are
 * left for the pictures that begin next. Thread safe.
 */
internal class ThreadShare(private val total: Int) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var free = total
    private var inputs = 0

    /** Waits for a thread, and calls [work] while it holds it. */
    fun <T> forInput(work: () -> T): T {
        lock.withLock {
            while (free == 0) changed.await()
            free--
            inputs++
        }
        try {
            return work()
        } finally {
            lock.withLock {
                inputs--
                giveBack(1)
            }
        }
    }

    /** Calls [work] with the number of threads for a picture, at least the one that the input holds. */
    fun <T> forPicture(work: (Int) -> T): T {
        val more = lock.withLock {
            // The others can take the same part when they begin a picture
            ((free + inputs - 1) / inputs).also { free -= it }
        }
        try {
            return work(1 + more)
        } finally {
            lock.withLock { giveBack(more) }
        }
    }

    private fun giveBack(threads: Int) {
        free += threads
        check(free <= total) { "more threads were given back than taken" }
        changed.signalAll()
    }
}
