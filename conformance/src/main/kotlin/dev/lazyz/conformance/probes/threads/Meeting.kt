package dev.lazyz.conformance.probes.threads

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.LockSupport

/**
 * Makes threads do the same at the same time: who comes waits for another thread that comes for the same, then both
 * go on at once, and both are known to be running.
 *
 * Two threads at a time meet, since more than there are processors would not run at the same time; others sleep as long as
 * these two go on meeting. All wait a little only, and no longer at all when nobody has come for a while, when two have
 * met [Where.enough] times, or after two seconds. Thread safe.
 */
internal class Meeting(private val where: Where) {
    private val waiting = AtomicReference<Arrival?>()
    private val missed = AtomicInteger()
    private val close = AtomicInteger()
    private val members = arrayOfNulls<Thread>(2)
    private val madeAt = System.nanoTime()

    @Volatile
    private var lastMet = System.nanoTime()

    /** Whether two threads have met. */
    @Volatile
    var hasMet: Boolean = false
        private set

    /** How often two threads have gone on at the same time; the system may have stopped one of them in between. */
    val closeMeetings: Int get() = close.get()

    /** Waits until another thread comes for [step]; who is at an earlier step goes on alone. */
    fun meet(step: Int) {
        if (isOver() || !isMember()) return
        while (true) {
            val other = waiting.get()
            when {
                other == null -> {
                    val own = Arrival(step)
                    if (waiting.compareAndSet(null, own)) return await(own)
                }

                other.step > step -> return

                waiting.compareAndSet(other, null) -> {
                    if (other.step == step) return join(other)
                    other.start = AT_ONCE
                }
            }
        }
    }

    private fun isOver(): Boolean =
        missed.get() > MOST_MISSED || close.get() >= where.enough || System.nanoTime() - madeAt > MOST_TIME

    /** Whether this thread is one of the two; if not, it waits for its turn. */
    private fun isMember(): Boolean {
        val thread = Thread.currentThread()
        if (members[0] === thread || members[1] === thread) return true
        while (!isAdmitted(thread)) {
            if (isOver()) return false
            LockSupport.parkNanos(NAP)
        }
        return true
    }

    @Synchronized
    private fun isAdmitted(thread: Thread): Boolean {
        val free = members.indexOf(null)
        if (free >= 0) {
            members[free] = thread
            return true
        }
        if (System.nanoTime() - lastMet < IDLE) return false

        // The two have gone separate ways
        members[0] = thread
        members[1] = null
        lastMet = System.nanoTime()
        return true
    }

    private fun await(own: Arrival) {
        val begin = System.nanoTime()
        while (own.start == NEVER) {
            // Only who runs says when to go on; the other is awake, and waits for this
            if (own.isJoined) own.start = System.nanoTime() + HEAD_START
            val waited = System.nanoTime() - begin
            if (waited > PATIENCE && waiting.compareAndSet(own, null)) {
                missed.incrementAndGet()
                return
            }
            if (waited > AWAKE) Thread.yield() else Thread.onSpinWait()
        }
        if (own.start != AT_ONCE) pause(own.start)
    }

    private fun join(other: Arrival) {
        other.isJoined = true
        while (other.start == NEVER) Thread.onSpinWait()
        missed.set(0)
        hasMet = true
        lastMet = other.start
        if (System.nanoTime() < other.start) close.incrementAndGet()
        pause(other.start)
    }

    /** Both look at the same clock, since one hears of the other late. */
    private fun pause(start: Long) {
        while (System.nanoTime() < start) Thread.onSpinWait()
    }

    private class Arrival(val step: Int) {
        @Volatile
        var isJoined: Boolean = false

        @Volatile
        var start: Long = NEVER
    }

    private companion object {
        const val NEVER = Long.MIN_VALUE
        const val AT_ONCE = Long.MIN_VALUE + 1

        /** Nanoseconds from the moment at which two have met to the one at which they go on. */
        const val HEAD_START = 1_000L

        /** Nanoseconds that one waits without making room for others. */
        const val AWAKE = 100_000L

        /** Nanoseconds that one waits: more than a busy system lets the other sleep. */
        const val PATIENCE = 20_000_000L

        /** Nanoseconds after which nobody waits any longer: where the processors are busy, meeting takes long. */
        const val MOST_TIME = 2_000_000_000L

        /** So often in a row one waits for nobody: 200 milliseconds in all. */
        const val MOST_MISSED = 10

        /** Nanoseconds without a meeting after which others have their turn. */
        const val IDLE = 10_000_000L

        /** Nanoseconds that the others sleep. */
        const val NAP = 200_000L
    }
}
