package dev.lazyz.conformance.run

import java.time.Duration
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** Thrown when a call makes no progress within its deadline. The message contains the stack traces of its threads. */
internal class Late(message: String, val lateness: Lateness) : RuntimeException(message)

/**
 * Makes calls one after the other in a single thread, separate from the caller's, so that a call that hangs can be
 * abandoned. The thread and the threads that it started are then interrupted, and the next call uses a new thread.
 */
internal class TryThread(limit: Duration) : AutoCloseable {
    private var group = ThreadGroup(all, NAME)
    private var executor: ExecutorService? = null
    private val deadline = Deadline(limit, { ThreadTimes.now(all, lost) })

    /** Restarts the deadline of the current call, because it has made progress. */
    fun goesOn() = deadline.progress()

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
                try {
                    return future.get(StallTimer.POLL.toMillis(), TimeUnit.MILLISECONDS)
                } catch (_: TimeoutException) {
                    deadline.lateness()?.let { throw late(it) }
                }
            }
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } catch (e: InterruptedException) {
            close()
            throw e
        }
    }

    private fun late(lateness: Lateness): Late {
        val where = where()
        if (lateness == Lateness.BUSY) lost += deadline.busyThreads()
        close()
        return Late("${deadline.words(lateness)}; it is at\n$where", lateness)
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
        group = ThreadGroup(all, NAME)
    }

    companion object {
        private const val NAME = "lazyz-conformance"
        private const val MOMENT = 500L
        private const val MOST_THREADS = 8
        private const val MOST_CALLS = 16

        /** The groups of all try threads: a renderer may keep threads that an earlier one has started. */
        private val all = ThreadGroup(NAME)

        /** The ids of threads that go on running after their call was given up, because they ignore interrupts. */
        private val lost = ConcurrentHashMap.newKeySet<Long>()
    }
}
