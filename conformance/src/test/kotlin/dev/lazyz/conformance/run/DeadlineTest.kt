package dev.lazyz.conformance.run

import java.time.Duration
import java.util.concurrent.TimeUnit
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class DeadlineTest {
    private var now = 0L

    /** Milliseconds of processor time by the number of a thread; those below [OTHERS] may work for the renderer. */
    private val used = HashMap<Long, Long>()
    private var isKnown = true
    private val deadline by lazy { Deadline(Duration.ofSeconds(20), ::times, { now }) }

    private fun times() = used.mapValues { nanoseconds(it.value) }.let { all ->
        ThreadTimes(all, all.filterKeys { it < OTHERS }, isKnown)
    }

    private fun nanoseconds(milliseconds: Long) = TimeUnit.MILLISECONDS.toNanos(milliseconds)

    /** Returns the verdict, and after how many polls, if [threads] get these milliseconds in each. */
    private fun verdict(vararg threads: Pair<Long, Long>): Pair<Lateness, Int> {
        var polls = 0
        for ((thread, _) in threads) used.putIfAbsent(thread, 0)
        while (true) {
            deadline.lateness()?.let { return it to polls }
            polls++
            now += StallTimer.POLL.toNanos()
            for ((thread, more) in threads) used.merge(thread, more, Long::plus)
        }
    }

    @Test
    fun aThreadThatRunsAllTheTimeIsBusy() = assertEquals(Lateness.BUSY to 200, verdict(1L to 100L))

    @Test
    fun aBusyMachineChangesNoVerdictUntilItsLoadIsTen() {
        assertEquals(Lateness.BUSY to 800, verdict(1L to 25L))
        deadline.progress()
        assertEquals(Lateness.UNKNOWN to 2000, verdict(1L to 5L))
        val words = "was not over after 200 s, but the machine gave it only 10 s of the 20 s of processor time"
        assertTrue(deadline.words(Lateness.UNKNOWN).startsWith(words), deadline.words(Lateness.UNKNOWN))
    }

    @Test
    fun manyThreadsHaveNoLessTime() {
        assertEquals(Lateness.BUSY to 200, verdict(1L to 100L, 2L to 90L, 3L to 90L, 4L to 5L))
        assertEquals(setOf(1L, 2L, 3L), deadline.busyThreads())
    }

    @Test
    fun threadsThatAllWaitAreAsleep() = assertEquals(Lateness.ASLEEP to 200, verdict(1L to 0L, OTHERS to 0L))

    /** It may work for the renderer without being known to: a thread of an executor that others have made. */
    @Test
    fun aForeignThreadThatRunsKeepsItOpen() = assertEquals(Lateness.UNKNOWN to 2000, verdict(1L to 0L, OTHERS to 100L))

    @Test
    fun progressStartsItAnew() {
        used[1] = 0
        assertNull(deadline.lateness())
        used[1] = 15_000
        assertNull(deadline.lateness())
        deadline.progress()
        assertNull(deadline.lateness())
        used[1] = 30_000
        assertNull(deadline.lateness())
        used[1] = 35_000
        assertEquals(Lateness.BUSY, deadline.lateness())
    }

    @Test
    fun withoutTheTimesNothingIsSaid() {
        isKnown = false
        assertEquals(Lateness.UNKNOWN to 2000, verdict())
    }

    @Test
    fun timesAreThoseOfTheThreads() {
        val group = ThreadGroup("mine")
        var sum = 0L
        val busy = Thread(group) { while (!Thread.interrupted()) sum += sum xor 7 }.apply { start() }
        try {
            val start = ThreadTimes.now(group, emptySet())
            fun used() = ThreadTimes.now(group, emptySet()).usedSince(start).getValue(busy.id)
            while (used() < nanoseconds(30)) Thread.onSpinWait()
            val now = ThreadTimes.now(group, emptySet())
            assertTrue(busy.id in now.own && Thread.currentThread().id !in now.all)
            assertTrue(busy.id !in ThreadTimes.now(group, setOf(busy.id)).all)
        } finally {
            busy.interrupt()
            busy.join()
        }
    }

    private companion object {
        const val OTHERS = 100L
    }
}
