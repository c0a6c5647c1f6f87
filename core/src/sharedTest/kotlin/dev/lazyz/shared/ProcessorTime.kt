package dev.lazyz.shared

import java.lang.management.ManagementFactory
import org.junit.jupiter.api.Assertions.assertTrue

/** What work takes of a processor, in the calling thread: unlike time on the wall, the same on a busy machine. */
internal object ProcessorTime {
    private const val GROWTH = 16
    private val threads = ManagementFactory.getThreadMXBean()

    /** Returns the processor time of [work] in nanoseconds. */
    fun of(work: () -> Unit): Long {
        val start = threads.currentThreadCpuTime
        work()
        return threads.currentThreadCpuTime - start
    }

    /**
     * Asserts that work takes linear time: 16 times as much of it takes at most 64 times as long, and not 256 times.
     *
     * @param most the larger of the two sizes, a multiple of 16
     * @param input makes an input of a size, which is not measured
     */
    fun <T> assertLinear(most: Int, input: (size: Int) -> T, work: (input: T, size: Int) -> Unit) {
        fun time(size: Int): Long {
            val made = input(size)
            return of { work(made, size) }
        }
        val small = (1..3).minOf { time(most / GROWTH) }
        val large = time(most)
        assertTrue(large <= 4 * GROWTH * small) { "$GROWTH times as much takes ${large / small} times as long" }
    }
}
