package dev.lazyz.conformance.run

import dev.lazyz.conformance.report.ConformanceReport
import java.lang.management.ManagementFactory
import java.time.Duration
import java.util.concurrent.ForkJoinWorkerThread

/** Why a call that is not over is given up. */
internal enum class Lateness {
    /** One of its threads has used the processor for the whole [Deadline]. */
    BUSY,

    /** No thread of the process has used the processor for as long as that: all of them wait. */
    ASLEEP,

    /** Neither is so, but the clock on the wall has run out: the machine was too busy to tell. */
    UNKNOWN,
}

/**
 * The deadline of something that goes on in this process, as processor time of its busiest thread. So the result does
 * not depend on other programs, on the number of processors, or on how many threads share the work.
 *
 * One thread polls [lateness]; any thread can report progress.
 *
 * @param limit most processor time between two reports of progress
 * @param times returns the processor time of each thread so far
 * @param clock returns nanoseconds, like [System.nanoTime]
 */
internal class Deadline(
    private val limit: Duration,
    private val times: () -> ThreadTimes,
    clock: () -> Long = System::nanoTime,
) {
    private val wall = StallTimer(limit.multipliedBy(WALL), clock)
    private val sleep = StallTimer(limit, clock)
    private var start = times()
    private var last = start

    @Volatile
    private var hasProgress = true

    /** Starts to measure anew. */
    fun progress() {
        hasProgress = true
    }

    /** Returns null while there is time left. Call it every [StallTimer.POLL]. */
    fun lateness(): Lateness? {
        val now = times()
        if (hasProgress) {
            hasProgress = false
            start = now
            wall.progress()
        }
        if (now.hasRunSince(last) || !now.isKnown) sleep.progress()
        last = now
        val isWallOver = wall.left() <= 0
        return when {
            now.usedSince(start).any { it.value >= limit.toNanos() } -> Lateness.BUSY
            sleep.left() <= 0 -> Lateness.ASLEEP
            isWallOver -> Lateness.UNKNOWN
            else -> null
        }
    }

    /** Returns the threads that have used most of the deadline. */
    fun busyThreads(): Set<Long> = last.usedSince(start).filterValues { it >= limit.toNanos() / 2 }.keys

    /** Describes [lateness], as the continuation of a sentence about the call. */
    fun words(lateness: Lateness): String = when (lateness) {
        Lateness.BUSY -> "was not over after ${seconds(limit)} of processor time"

        Lateness.ASLEEP -> "was not over after ${seconds(limit)} in which no thread was running"

        Lateness.UNKNOWN -> {
            val most = last.usedSince(start).maxOfOrNull { it.value } ?: 0
            val used = Duration.ofNanos(most / HUNDREDTH * HUNDREDTH)
            "was not over after ${seconds(limit.multipliedBy(WALL))}, but the machine gave it only ${seconds(used)} " +
                "of the ${seconds(limit)} of processor time that it may use"
        }
    }

    companion object {
        /** How many times the deadline may pass on the wall: a machine with a load of ten gets a result. */
        const val WALL: Long = 10

        private const val HUNDREDTH = 10_000_000L

        /** Formats a duration, such as `20 s` or `0.5 s`. */
        fun seconds(duration: Duration): String = "${ConformanceReport.plain(duration.toMillis() / 1000.0)} s"
    }
}

/**
 * Processor time of threads, in nanoseconds by the id of the thread.
 *
 * @property all the time of all threads but the one that reads them
 * @property own the time of those that may work for the renderer; threads that are not known to do so can keep a call
 *   from counting as asleep, but cannot use up its deadline
 * @property isKnown whether this JVM measures the times
 */
internal class ThreadTimes(val all: Map<Long, Long>, val own: Map<Long, Long>, val isKnown: Boolean = true) {
    /**
     * Returns whether a thread that may work for the renderer has run since [earlier], or others have done more than
     * look whether there is something to do, as threads of build tools often do.
     */
    fun hasRunSince(earlier: ThreadTimes): Boolean =
        own != earlier.own || all.entries.sumOf { (id, time) -> time - (earlier.all[id] ?: 0) } > LOOK

    /** Returns the time that each thread which may work for the renderer has used since [start]. */
    fun usedSince(start: ThreadTimes): Map<Long, Long> = own.mapValues { (id, time) -> time - (start.own[id] ?: 0) }

    companion object {
        private val bean = ManagementFactory.getThreadMXBean()
        private const val MORE = 64

        /** Nanoseconds. */
        private const val LOOK = 1_000_000L

        /**
         * Reads the times now. Threads of [group], and those of common pools, may work for the renderer. Those with an
         * id in [lost] do not count.
         */
        fun now(group: ThreadGroup, lost: Set<Long>): ThreadTimes {
            if (!bean.isThreadCpuTimeSupported || !bean.isThreadCpuTimeEnabled) {
                return ThreadTimes(emptyMap(), emptyMap(), isKnown = false)
            }
            val top = generateSequence(group) { it.parent }.last()
            val threads = arrayOfNulls<Thread>(2 * top.activeCount() + MORE)
            val others = threads.take(top.enumerate(threads)).filterNotNull()
                .filter { it !== Thread.currentThread() && it.id !in lost }
            val all = others.associate { it.id to bean.getThreadCpuTime(it.id) }
            val own = others.filter { it is ForkJoinWorkerThread || it.threadGroup?.let(group::parentOf) == true }
            return ThreadTimes(all, own.associate { it.id to all.getValue(it.id) })
        }
    }
}

/**
 * Measures how long something makes no progress, up to [limit]. Time in which the process or the machine is suspended
 * does not count: the waiting thread asks at least every [POLL], so a much longer time between two questions is a pause
 * of the waiting thread, too, and counts as [LONGEST_STEP].
 *
 * One thread waits; any thread can report progress.
 *
 * @param clock returns nanoseconds, like [System.nanoTime]
 */
internal class StallTimer(private val limit: Duration, private val clock: () -> Long = System::nanoTime) {
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
