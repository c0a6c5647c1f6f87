package dev.lazyz.server.render

import java.util.concurrent.atomic.AtomicLong

/** An amount of memory that is given out in parts. Thread safe. */
internal class MemoryBudget(val total: Long) {
    private val taken = AtomicLong()

    /** The bytes that are given out. */
    val used: Long get() = taken.get()

    /** Takes [bytes], or returns false if there are fewer. */
    fun tryTake(bytes: Long): Boolean {
        while (true) {
            val now = taken.get()
            if (bytes > total - now) return false
            if (taken.compareAndSet(now, now + bytes)) return true
        }
    }

    /** Gives back [bytes]. */
    fun giveBack(bytes: Long) {
        check(taken.addAndGet(-bytes) >= 0) { "more was given back than was taken" }
    }
}
