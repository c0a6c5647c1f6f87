package dev.lazyz.conformance

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference

/**
 * Makes threads do the same at the same time: who comes waits for another thread that comes for the same, then both
 * go on at once. Waits a little only, and no longer at all when nobody has come for a while. Thread safe.
 */
internal class Meeting {
    private val waiting = AtomicReference<Arrival?>()
    private val missed = AtomicInteger()

    /** Whether two threads have met. */
    @Volatile
    var hasMet: Boolean = false
        private set

    /** Waits until another thread comes for [what]; goes on if somebody waits for something else. */
    fun meet(what: Int) {
        if (missed.get() > MOST_MISSED) return
        val other = waiting.get()
        if (other == null) {
            val own = Arrival(what)
            if (waiting.compareAndSet(null, own)) await(own)
        } else if (other.what == what && waiting.compareAndSet(other, null)) {
            missed.set(0)
            hasMet = true
            val start = System.nanoTime() + HEAD_START
            other.start = start
            pause(start)
        }
    }

    private fun await(own: Arrival) {
        val begin = System.nanoTime()
        while (own.start == NEVER) {
            val waited = System.nanoTime() - begin
            if (waited > PATIENCE && waiting.compareAndSet(own, null)) {
                missed.incrementAndGet()
                return
            }
            if (waited > AWAKE) Thread.yield() else Thread.onSpinWait()
        }
        pause(own.start)
    }

    /** Both look at the same clock, since one hears of the other late. */
    private fun pause(start: Long) {
        while (System.nanoTime() < start) Thread.onSpinWait()
    }

    private class Arrival(val what: Int) {
        @Volatile
        var start: Long = NEVER
    }

    private companion object {
        const val NEVER = Long.MIN_VALUE

        /** Nanoseconds from the moment at which two have met to the one at which they go on. */
        const val HEAD_START = 2_000L

        /** Nanoseconds that one waits without making room for others. */
        const val AWAKE = 30_000L

        /** Nanoseconds that one waits. */
        const val PATIENCE = 250_000L

        /** So often in a row one waits for nobody: 50 milliseconds in all. */
        const val MOST_MISSED = 200
    }
}
