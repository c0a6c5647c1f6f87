package dev.lazyz.conformance.run

import dev.lazyz.conformance.report.ConformanceReport
import java.time.Duration
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** Thrown when a call makes no progress within its deadline. The message contains the stack traces of its threads. */
internal class Late(message: String) : RuntimeException(message)

/**
 * Makes calls one after the other in a single thread, separate from the caller's, so that a call that hangs can be
 * abandoned. The thread and the threads that it started are then interrupted, and the next call uses a new thread.
 */
internal class TryThread(private val deadline: Duration) : AutoCloseable {
    private var group = ThreadGroup(NAME)
    private var executor: ExecutorService? = null
    private val patience = Patience(deadline)

    /** Restarts the deadline of the current call, because it has made progress. */
    fun goesOn() = patience.progress()

    /**
     * Returns what [block] returns, or throws what it throws.
     *
     * @throws Late if the call neither ends nor makes progress within the deadline
     */
    fun <T> call(block: () -> T): T {
        goesOn()
        val future = executor().submit(Callable { block() })
        try {
            while (true) {
                val left = patience.left()
                if (left <= 0) throw late()
                try {
                    return future.get(left, TimeUnit.NANOSECONDS)
                } catch (_: TimeoutException) {
                    // It may have made progress meanwhile
                }
            }
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } catch (e: InterruptedException) {
            close()
            throw e
        }
    }

    private fun late(): Late {
        val where = where()
        close()
        return Late("was not over after ${seconds(deadline)}; it is at\n$where")
    }

    private fun executor(): ExecutorService = executor ?: Executors.newSingleThreadExecutor { task ->
        Thread(group, task, NAME).apply { isDaemon = true }
    }.also { executor = it }

    /** Stack traces of the thread and of the threads that it started. */
    private fun where(): String {
        val threads = arrayOfNulls<Thread>(MOST_THREADS)
        val count = group.enumerate(threads)
        return threads.take(count).filterNotNull().joinToString("\n") { thread ->
            val calls = thread.stackTrace.takeWhile { !it.className.startsWith("jdk.internal.reflect.") }
            "    thread ${thread.name} (${thread.state})" +
                calls.take(MOST_CALLS).joinToString("") { "\n        $it" }
        }
    }

    /** Interrupts what still runs, waits briefly for its end, and abandons it. */
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

        /** Formats a duration, such as `20 s` or `0.5 s`. */
        fun seconds(duration: Duration): String = "${ConformanceReport.plain(duration.toMillis() / 1000.0)} s"
    }
}
