package dev.lazyz.conformance.run

import java.time.Duration

/**
 * Measures how long something makes no progress, up to [limit]. Time in which the process or the machine is suspended
 * does not count: the waiting thread asks at least every [POLL], so a much longer time between two questions is a pause
 * of the waiting thread, too, and counts as [LONGEST_STEP].
 *
 * One thread waits; any thread can report progress.
 *
 * @param clock returns nanoseconds, like [System.nanoTime]
 */
internal class Patience(private val limit: Duration, private val clock: () -> Long = System::nanoTime) {
    @Volatile
    private var hasProgress = true
    private var last = clock()
    private var waited = 0L

    /** Starts to measure anew. */
    fun progress() {
        hasProgress = true
    }

    /** Returns the time that is left, at most [POLL], or a number below 1 if the limit is exceeded. Nanoseconds. */
    fun left(): Long {
        val now = clock()
        val step = minOf(now - last, LONGEST_STEP.toNanos())
        last = now
        if (hasProgress) {
            hasProgress = false
            waited = 0
        } else {
            waited += step
        }
        return minOf(limit.toNanos() - waited, POLL.toNanos())
    }

    companion object {
        /** Longest time between two calls of [left] by a thread that waits. */
        val POLL: Duration = Duration.ofMillis(100)

        /** What counts of a longer time. Ten times [POLL]: threads of a busy machine are late, too. */
        val LONGEST_STEP: Duration = Duration.ofSeconds(1)
    }
}
