package dev.lazyz.conformance.run

import java.time.Duration
import java.util.concurrent.TimeUnit
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StallTimerTest {
    private var now = 0L
    private val patience = StallTimer(Duration.ofSeconds(20)) { now }

    private fun leftAfter(milliseconds: Long): Long {
        now += TimeUnit.MILLISECONDS.toNanos(milliseconds)
        return patience.left()
    }

    @Test
    fun itEndsAfterTheLimit() {
        leftAfter(0)
        val polls = generateSequence { leftAfter(100) }.takeWhile { it > 0 }.count()
        assertEquals(199, polls)
    }

    @Test
    fun progressStartsItAnew() {
        leftAfter(0)
        repeat(150) { assertTrue(leftAfter(100) > 0) }
        patience.progress()
        repeat(200) { assertTrue(leftAfter(100) > 0) }
        assertEquals(0, leftAfter(100))
    }

    @Test
    fun aSuspendedMachineDoesNotCount() {
        leftAfter(0)
        assertTrue(leftAfter(TimeUnit.HOURS.toMillis(8)) > 0)
        repeat(189) { assertTrue(leftAfter(100) > 0) }
        assertEquals(0, leftAfter(100))
    }

    @Test
    fun noWaitIsLongerThanThePoll() {
        assertEquals(StallTimer.POLL.toNanos(), leftAfter(0))
        repeat(199) { leftAfter(100) }
        assertEquals(TimeUnit.MILLISECONDS.toNanos(60), leftAfter(40))
    }
}
