package dev.lazyz.conformance.run

import dev.lazyz.conformance.report.ConformanceReport
import java.time.Duration
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** A call did not go on within its deadline; the message says where its threads are. */
internal class Late(message: String) : RuntimeException(message)

/**
 * Makes calls one after the other, all in one thread that is not the caller's, so that one that hangs can be left
 * behind. The thread and those that it starts are interrupted then; the next call has another.
 */
internal class TryThread(private val deadline: Duration) : AutoCloseable {
    private var group = ThreadGroup(NAME)
    private var executor: ExecutorService? = null

    @Volatile
    private var since = 0L

    /** The call under way has done a part of what it does: from here on, its deadline begins anew. */
    fun goesOn() {
        since = System.nanoTime()
    }

    /**
     * Returns what [block] returns, or throws what it throws.
     *
     * @throws Late if it is not over in time, nor goes on
     */
    fun <T> call(block: () -> T): T {
        goesOn()
        val future = executor().submit(Callable { block() })
        try {
            while (true) {
                try {
                    return future.get(left(), TimeUnit.NANOSECONDS)
                } catch (late: TimeoutException) {
                    if (left() <= 0) throw late
                }
            }
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } catch (_: TimeoutException) {
            val where = where()
            close()
            throw Late("was not over after ${seconds(deadline)}; it is at\n$where")
        } catch (e: InterruptedException) {
            close()
            throw e
        }
    }

    /** Nanoseconds until the deadline. */
    private fun left(): Long = deadline.toNanos() - (System.nanoTime() - since)

    private fun executor(): ExecutorService = executor ?: Executors.newSingleThreadExecutor { task ->
        Thread(group, task, NAME).apply { isDaemon = true }
    }.also { executor = it }

    /** Stack traces of the thread and of those that it has started. */
    private fun where(): String {
        val threads = arrayOfNulls<Thread>(MOST_THREADS)
        val count = group.enumerate(threads)
        return threads.take(count).filterNotNull().joinToString("\n") { thread ->
            val calls = thread.stackTrace.takeWhile { !it.className.startsWith("jdk.internal.reflect.") }
            "    thread ${thread.name} (${thread.state})" +
                calls.take(MOST_CALLS).joinToString("") { "\n        $it" }
        }
    }

    /** Interrupts what still runs, gives it a moment to end, and goes on without it. */
    override fun close() {
        val executor = executor ?: return
        executor.shutdownNow()
        if (!executor.awaitTermination(MOMENT, TimeUnit.MILLISECONDS)) group.interrupt()
        this.executor = null
        group = ThreadGroup(NAME)
    }

    companion object {
        private const val NAME = "lazyz-conformance"
        private const val MOMENT = 500L
        private const val MOST_THREADS = 8
        private const val MOST_CALLS = 16

        /** A duration in words, such as `20 s` or `0.5 s`. */
        fun seconds(duration: Duration): String = "${ConformanceReport.plain(duration.toMillis() / 1000.0)} s"
    }
}
