package dev.lazyz

import java.util.concurrent.Executor
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.SynchronousQueue
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The threads for a rendering or a set-up: the calling thread, and helpers from an executor. All threads of the library
 * come from here.
 *
 * The calling thread takes part in the work and never waits for a helper to begin. If the executor is busy, rejects
 * tasks, or runs them late, the calling thread does the work alone. Thread safe.
 *
 * @property threads maximum number of threads, including the calling thread
 * @property executor runs the helpers
 */
internal class Workers(val threads: Int, val executor: Executor) {
    /**
     * Calls [action] for each number in 0 until [count], on several threads if there are several numbers. If a call
     * throws, those that have not begun are skipped, those that run on other threads end at their next checkpoint, and
     * the first exception is thrown to the caller.
     *
     * @param checkpoint ends the work of all threads when it ends that of the calling thread. It is passed before each
     *   call there, and when the calling thread is interrupted while it waits for the others
     * @param action gets the checkpoint of its thread, for calls that take long
     */
    fun forEach(count: Int, checkpoint: Checkpoint, action: (number: Int, checkpoint: Checkpoint) -> Unit) {
        val helperCount = minOf(threads, count) - 1
        val loop = SharedLoop(count, action)
        val helpers = Helpers(executor)
        try {
            repeat(helperCount) { helpers.start { loop.takePart(loop) } }
            loop.takePart(checkpoint)
            if (loop.failure.get() == null) loop.run { helpers.await(checkpoint) }
        } finally {
            helpers.end(interrupt = loop.failure.get() != null)
        }
        loop.failure.get()?.let { throw it }
    }

    /** Numbers that several threads take one by one. Itself the checkpoint of the other threads. */
    private class SharedLoop(
        private val count: Int,
        private val action: (number: Int, checkpoint: Checkpoint) -> Unit,
    ) : Checkpoint {
        private val next = AtomicInteger()
        val failure = AtomicReference<Throwable>()

        override fun pass() {
            failure.get()?.let { throw it }
        }

        fun takePart(checkpoint: Checkpoint) = run {
            while (failure.get() == null) {
                val number = next.getAndIncrement()
                if (number >= count) return
                checkpoint.pass()
                action(number, checkpoint)
            }
        }

        /** Keeps what [work] throws, if it is the first failure. */
        inline fun run(work: () -> Unit) {
            try {
                work()
            } catch (e: Throwable) {
                val isFirst = failure.compareAndSet(null, e)

                // Another exception is thrown in place of this one, which must not hide an interrupt
                if (!isFirst && e is InterruptedException && failure.get() !== e) Thread.currentThread().interrupt()
            }
        }
    }

    companion object {
        /** As many threads as there are processors, from the library's own pool. */
        val ALL = Workers(Runtime.getRuntime().availableProcessors(), LibraryThreads)
    }
}

/**
 * The helpers of the thread that creates this, for one piece of work. Not thread safe.
 *
 * @param executor runs the helpers
 */
internal class Helpers(private val executor: Executor) {
    private val caller = Thread.currentThread()
    private val helpers = ArrayList<Helper>()

    /** Lets a helper do [work] as soon as the executor has a thread for it. Exceptions of [work] are not reported. */
    fun start(work: () -> Unit) {
        // Add it first: whatever fails after that, a helper that has begun is waited for
        val helper = Helper(caller, work)
        helpers += helper
        try {
            executor.execute(helper)
        } catch (_: RejectedExecutionException) {
            // The calling thread does the work
        } catch (_: OutOfMemoryError) {
            // So it does if no thread can be created
        }
    }

    /**
     * Waits until no helper works. If the calling thread is interrupted, passes [checkpoint], and returns at once; the
     * status stays set.
     */
    fun await(checkpoint: Checkpoint) {
        try {
            for (helper in helpers) helper.awaitEnd()
        } catch (_: InterruptedException) {
            caller.interrupt()
            checkpoint.pass()
        }
    }

    /**
     * Waits until all helpers that have begun have ended; the others never begin. An interrupt of the calling thread
     * does not end the wait, and stays set.
     *
     * @param interrupt whether to interrupt the helpers, which may be blocked
     */
    fun end(interrupt: Boolean) {
        for (helper in helpers) helper.withdraw(interrupt)
        var isInterrupted = false
        for (helper in helpers) {
            while (true) {
                try {
                    helper.awaitEnd()
                    break
                } catch (_: InterruptedException) {
                    isInterrupted = true
                }
            }
        }
        if (isInterrupted) caller.interrupt()
    }

    private class Helper(private val caller: Thread, private var work: (() -> Unit)?) : Runnable {
        private val lock = ReentrantLock()
        private val ended = lock.newCondition()
        private var thread: Thread? = null
        private var isInterrupted = false

        override fun run() {
            // An executor may run the task at once, in the calling thread, which has to do its own part
            if (Thread.currentThread() === caller) return
            val work = begin() ?: return
            try {
                work()
            } finally {
                finish()
            }
        }

        private fun begin(): (() -> Unit)? = lock.withLock {
            if (work != null) thread = Thread.currentThread()
            work
        }

        private fun finish() = lock.withLock {
            // The interrupt was meant for this work, and not for the next task of the executor
            if (isInterrupted) Thread.interrupted()
            thread = null
            work = null
            ended.signalAll()
        }

        /** If the helper has not begun, it never will, and no longer refers to its work. */
        fun withdraw(interrupt: Boolean) = lock.withLock {
            if (thread == null) work = null
            isInterrupted = interrupt && thread != null
            if (isInterrupted) thread?.interrupt()
        }

        fun awaitEnd() = lock.withLock { while (thread != null) ended.await() }
    }
}

/** The library's own threads: daemons, as many as are needed at the same time. They end when they are not used. */
internal object LibraryThreads : Executor {
    private const val IDLE_SECONDS = 1L

    private val number = AtomicInteger()
    private val pool =
        ThreadPoolExecutor(0, Int.MAX_VALUE, IDLE_SECONDS, TimeUnit.SECONDS, SynchronousQueue()) { task ->
            Thread(task, "lazyz-${number.incrementAndGet()}").apply {
                isDaemon = true

                // The pool serves all callers, and must not keep the classes of the first one
                contextClassLoader = LibraryThreads::class.java.classLoader
            }
        }

    override fun execute(task: Runnable) = pool.execute(task)
}
