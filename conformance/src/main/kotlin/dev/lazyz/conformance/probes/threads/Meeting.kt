package dev.lazyz.conformance.probes.threads

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.LockSupport

/**
 * Makes threads do the same step at the same time: a thread waits for another thread with the same step, then both
 * continue at once, while both are known to be running.
 *
 * Two threads at a time meet, since more threads than processors would not run at the same time. The others sleep as
 * long as these two continue to meet. Each wait is short, and waiting ends altogether after several waits in vain,
 * after [Where.enough] meetings, or after two seconds. Thread safe.
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

    /**
     * How often two threads have continued at the same time, although the system may have stopped one of them in
     * between.
     */
    val closeMeetings: Int get() = close.get()

    /** Waits until another thread arrives with the same [step]. A thread with an earlier step continues alone. */
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

    /**
     * Returns whether this thread is one of the two that meet; otherwise waits until it is, or until the meeting is
     * over.
     */
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

        // The two threads no longer meet each other
        members[0] = thread
        members[1] = null
        lastMet = System.nanoTime()
        return true
    }

    private fun await(own: Arrival) {
        val begin = System.nanoTime()
        while (own.start == NEVER) {
            // The waiting thread sets the time, because it is running; the joining thread spins until it is set
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

    /** Both threads wait for the same time, because each sees the other's writes with a delay. */
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

        /** Nanoseconds from the moment when two threads have met until they continue. */
        const val HEAD_START = 1_000L

        /** Nanoseconds that a thread waits without yielding. */
        const val AWAKE = 100_000L

        /** Nanoseconds that a thread waits at most: more than a busy system delays the other one. */
        const val PATIENCE = 20_000_000L

        /** Nanoseconds after which no thread waits any longer. On a busy machine meetings take long. */
        const val MOST_TIME = 2_000_000_000L

        /** Number of consecutive waits in vain after which no thread waits any longer: 200 milliseconds in total. */
        const val MOST_MISSED = 10

        /** Nanoseconds without a meeting after which other threads take their turn. */
        const val IDLE = 10_000_000L

        /** Nanoseconds that the other threads sleep. */
        const val NAP = 200_000L
    }
}
