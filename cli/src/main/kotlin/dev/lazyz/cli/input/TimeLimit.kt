package dev.lazyz.cli.input

import dev.lazyz.cli.output.Mistake
import java.lang.management.ManagementFactory
import java.math.BigDecimal
import java.time.Duration
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * The option `--max-seconds`: limits the processor time for everything that is done with one input. What counts is the
 * time of the thread that reads the input and renders, which takes part in the work of all others, so that a busy
 * machine refuses nothing; ten times as long on the clock on the wall is a net. The work is interrupted; it ends at the
 * next step of reading, at the next tile or row of a picture, or when a strategy that holds the whole picture has
 * computed it.
 *
 * @property patience how long to wait for that end, in milliseconds; 0 is without limit. Work that then still runs is
 *   left alone, and ends with the process, which deletes its temporary files
 */
internal enum class TimeLimit(private val patience: Long) {
    /** For the last work of the process. */
    OF_PROCESS(1000),

    /** For an input that others follow, which need the memory and the threads. */
    OF_INPUT(0),
    ;

    /**
     * Returns the result of [work] for the input [name], within [limit].
     *
     * @throws Mistake if it takes longer
     */
    fun <T> hold(limit: Duration?, name: String, work: () -> T): T {
        if (limit == null) return work()
        val task = FutureTask(work)
        val worker = Thread(task, "zcli-work").apply { isDaemon = true }
        worker.start()
        try {
            if (isOverWithin(limit, task, worker)) return task.get()
            worker.interrupt()
            worker.join(patience)
            return finished(task) ?: throw Mistake(
                "$name: takes more than ${seconds(limit)} s to read and render; raise --max-seconds",
            )
        } catch (failed: ExecutionException) {
            throw failed.cause ?: failed
        } catch (interrupted: InterruptedException) {
            worker.interrupt()
            throw interrupted
        }
    }

    /** Waits for [task], which [worker] runs, and returns whether it has ended within [limit]. */
    private fun isOverWithin(limit: Duration, task: FutureTask<*>, worker: Thread): Boolean {
        val threads = ManagementFactory.getThreadMXBean()
        val end = System.nanoTime() + limit.multipliedBy(WALL).toNanos()
        while (true) {
            // A thread that has ended, or a JVM that does not measure it, has used -1
            val left = minOf(limit.toNanos() - threads.getThreadCpuTime(worker.id), end - System.nanoTime())
            if (task.isDone) return true
            if (left <= 0) return false
            try {
                task.get(minOf(left, MOMENT), TimeUnit.NANOSECONDS)
            } catch (_: TimeoutException) {
                // It may have used less
            } catch (_: ExecutionException) {
                return true
            }
        }
    }

    private fun seconds(limit: Duration): String =
        BigDecimal.valueOf(limit.toMillis(), 3).stripTrailingZeros().toPlainString()

    /** Returns the result of [task] if it has one; its failure may be due to the interrupt. */
    private fun <T> finished(task: FutureTask<T>): T? = try {
        if (task.isDone) task.get() else null
    } catch (_: ExecutionException) {
        null
    }

    private companion object {
        const val WALL = 10L

        /** Nanoseconds between two looks at the processor time. */
        const val MOMENT = 100_000_000L
    }
}
