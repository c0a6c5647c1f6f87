package dev.lazyz.server.render

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Renders jobs in the order in which they arrive: at most [threads] at the same time, and only as many as there is
 * memory for. A job that must wait for memory is not overtaken by smaller ones, so each gets its turn. Thread safe.
 *
 * @property threads jobs that run at the same time
 * @property capacity further jobs that can wait
 * @property memory bytes of memory for the jobs that run, and for pictures that are not yet sent
 */
internal class RenderQueue(private val threads: Int, private val capacity: Int, val memory: Long) : AutoCloseable {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val jobs = ArrayDeque<RenderJob>()
    private var isClosed = false
    private val workers = List(threads) { number ->
        Thread({ run() }, "lazyz-render-$number").apply {
            isDaemon = true
            start()
        }
    }

    /** The jobs that wait. */
    val waiting: Int get() = lock.withLock { jobs.size }

    /** The jobs that run. */
    var running = 0
        get() = lock.withLock { field }
        private set

    /** The bytes of memory that are taken. */
    var taken = 0L
        get() = lock.withLock { field }
        private set

    /** Whether another job would be refused. */
    val isFull: Boolean get() = lock.withLock { isClosed || jobs.size + running >= threads + capacity }

    /** Adds [job], or returns false if the queue is full. */
    fun offer(job: RenderJob): Boolean = lock.withLock {
        check(job.need <= memory) { "the job needs ${job.need} bytes of $memory" }
        if (isFull) return false
        jobs.addLast(job)
        changed.signalAll()
        true
    }

    /**
     * Takes as much memory for [job], whose work calls this, that it has [need] bytes.
     *
     * @throws MoreMemory if they are not free now. Waiting here could last forever: others that wait hold memory, too
     * @throws Problem if there is never that much
     */
    fun grow(job: RenderJob, need: Long): Unit = lock.withLock {
        if (need <= job.need) return
        if (need > memory) {
            val message = "drawing this model needs $need bytes of memory, and there are $memory; choose a smaller " +
                "picture or aa, or a model with fewer triangles or translucent layers"
            throw Problem(Problem.TOO_LARGE, message)
        }
        if (need - job.need > memory - taken) throw MoreMemory(need)
        taken += need - job.need
        job.need = need
    }

    /** Ends [job] with [reason]: takes it out of the queue, or interrupts its work. */
    fun cancel(job: RenderJob, reason: Problem) {
        val wasWaiting = lock.withLock {
            val wasWaiting = jobs.remove(job)
            if (!wasWaiting && job.thread != null && job.reason == null) {
                job.reason = reason
                job.thread?.interrupt()
            }
            if (wasWaiting) changed.signalAll()
            wasWaiting
        }
        if (wasWaiting) job.ended(RenderJob.Outcome(null, reason))
    }

    /** Ends [job] with [reason] if its work has not begun. */
    fun cancelIfWaiting(job: RenderJob, reason: Problem) {
        val wasWaiting = lock.withLock { jobs.remove(job).also { if (it) changed.signalAll() } }
        if (wasWaiting) job.ended(RenderJob.Outcome(null, reason))
    }

    /** Gives back the memory of a picture. */
    fun giveBack(bytes: Long): Unit = lock.withLock {
        taken -= bytes
        changed.signalAll()
    }

    /** Refuses further jobs, cancels all others, and waits for the threads. */
    override fun close() {
        val left = lock.withLock {
            isClosed = true
            changed.signalAll()
            for (worker in workers) worker.interrupt()
            jobs.toList().also { jobs.clear() }
        }
        for (job in left) job.ended(RenderJob.Outcome(null, CLOSED))
        for (worker in workers) worker.join()
    }

    private fun run() {
        while (true) {
            val job = next() ?: return
            job.started()
            val outcome = try {
                outcome(job)
            } catch (more: MoreMemory) {
                if (retry(job, more.need)) continue
                RenderJob.Outcome(null, CLOSED)
            }
            val final = lock.withLock {
                stop(job)
                val reason = job.reason
                val final = if (reason == null) outcome else RenderJob.Outcome(null, reason)
                taken += final.picture?.memory ?: 0
                final
            }
            job.ended(final)
        }
    }

    /** Puts [job] in front of all others, to begin again with [need] bytes, unless it must end. */
    private fun retry(job: RenderJob, need: Long): Boolean = lock.withLock {
        if (isClosed || job.reason != null) return false
        stop(job)
        job.need = need
        jobs.addFirst(job)
        true
    }

    /** Takes its thread and its memory from [job]. No interrupt for it comes after this. */
    private fun stop(job: RenderJob) {
        job.thread = null
        Thread.interrupted()
        running--
        taken -= job.need
        changed.signalAll()
    }

    /** Returns the first job, as soon as there is memory for it, or null if the queue is closed. */
    private fun next(): RenderJob? = lock.withLock {
        while (true) {
            if (isClosed) return null
            val first = jobs.firstOrNull()
            if (first != null && first.need <= memory - taken) {
                jobs.removeFirst()
                first.thread = Thread.currentThread()
                running++
                taken += first.need
                return first
            }
            try {
                changed.await()
            } catch (_: InterruptedException) {
                // Only close() interrupts a thread that waits
            }
        }
        @Suppress("UNREACHABLE_CODE")
        null
    }

    private fun outcome(job: RenderJob): RenderJob.Outcome = try {
        RenderJob.Outcome(job.work(job), null)
    } catch (more: MoreMemory) {
        throw more
    } catch (problem: Problem) {
        RenderJob.Outcome(null, problem)
    } catch (unreadable: SceneReadException) {
        // Its message can name a path of the server, which is for the log
        RenderJob.Outcome(null, Problem(Problem.BUG, "the server cannot read a file"), unreadable)
    } catch (invalid: SceneFormatException) {
        RenderJob.Outcome(null, Problem(Problem.UNPROCESSABLE, invalid.message.orEmpty()))
    } catch (_: InterruptedException) {
        RenderJob.Outcome(null, CLOSED)
    } catch (_: OutOfMemoryError) {
        RenderJob.Outcome(null, Problem(Problem.UNAVAILABLE, "the memory is used up; try a smaller model or picture"))
    } catch (bug: Throwable) {
        RenderJob.Outcome(null, Problem(Problem.BUG, "the server has failed: this is a bug"), bug)
    }

    private companion object {
        val CLOSED = Problem(Problem.UNAVAILABLE, "the server is closed")
    }
}
