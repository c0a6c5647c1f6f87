package dev.lazyz.server.render

import dev.lazyz.scenes.ClientText
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.time.Duration
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Renders jobs in the order in which they arrive: at most [threads] at the same time, and only as many as there is
 * memory for. A job that must wait for memory is not overtaken by smaller ones, so each gets its turn. Thread safe.
 *
 * A job that is cancelled has [patience] to react. Then the queue gives up on it: the job ends, and another thread
 * takes the place of the one that hangs, which keeps its memory until it returns. At most as many threads are replaced
 * as jobs run at the same time, since those that hang take processor time.
 *
 * @property threads jobs that run at the same time
 * @property capacity further jobs that can wait
 * @property memory bytes of memory for the jobs that run, and for pictures that are not yet sent
 */
internal class RenderQueue(
    private val threads: Int,
    private val capacity: Int,
    val memory: Long,
    private val patience: Duration = Duration.ofSeconds(5),
) : AutoCloseable {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val jobs = ArrayDeque<QueuedJob>()
    private val atWork = LinkedHashSet<QueuedJob>()
    private val workers = LinkedHashSet<Thread>()
    private val watch = ScheduledThreadPoolExecutor(1) { Thread(it, "lazyz-render-watch").apply { isDaemon = true } }
    private var isClosed = false

    /** The threads that take jobs: all but those that hang. */
    private var active = 0
    private var hangingMemory = 0L

    init {
        lock.withLock { repeat(threads) { startWorker() } }
    }

    /** The jobs that wait. */
    val waiting: Int get() = lock.withLock { jobs.size }

    /** The jobs that run, without those that are given up. */
    val running: Int get() = lock.withLock { atWork.size }

    /** The threads that hang: their jobs are given up, and they have not returned. */
    var hanging = 0
        get() = lock.withLock { field }
        private set

    /** The bytes of memory that are taken. */
    var taken = 0L
        get() = lock.withLock { field }
        private set

    /** Whether another job would be refused. */
    val isFull: Boolean
        get() = lock.withLock { isClosed || active == 0 || jobs.size + atWork.size >= threads + capacity }

    /** Whether nothing is rendered: all threads hang, or those that hang hold the memory that the next job needs. */
    val isStuck: Boolean
        get() = lock.withLock {
            active == 0 || (hangingMemory > 0 && jobs.isNotEmpty() && jobs.first().need > memory - hangingMemory)
        }

    /** Adds [job], or returns false if the queue is full. */
    fun offer(job: QueuedJob): Boolean = lock.withLock {
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
    fun grow(job: QueuedJob, need: Long): Unit = lock.withLock {
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
    fun cancel(job: QueuedJob, reason: Problem) {
        if (cancelIfWaiting(job, reason)) return
        lock.withLock {
            if (job !in atWork || job.reason != null || isClosed) return
            stop(job, reason)
            watch.schedule({ giveUp(job) }, patience.toMillis(), TimeUnit.MILLISECONDS)
        }
    }

    /** Ends [job] with [reason] if its work has not begun. Returns whether it did. */
    fun cancelIfWaiting(job: QueuedJob, reason: Problem): Boolean {
        val wasWaiting = lock.withLock { jobs.remove(job).also { if (it) changed.signalAll() } }
        if (wasWaiting) drop(job, reason)
        return wasWaiting
    }

    /** Gives back the memory of a picture. */
    fun giveBack(bytes: Long): Unit = lock.withLock {
        taken -= bytes
        changed.signalAll()
    }

    /**
     * Refuses further jobs, cancels all others, and waits for the threads, at most 2 seconds. Those that hang are left.
     */
    override fun close() {
        val left = lock.withLock {
            isClosed = true
            watch.shutdownNow()
            for (job in atWork) if (job.reason == null) stop(job, CLOSED)
            changed.signalAll()
            jobs.toList().also { jobs.clear() }
        }
        for (job in left) drop(job, CLOSED)
        lock.withLock {
            var rest = minOf(patience, LAST_WAIT).toNanos()
            while (workers.size > hanging && rest > 0) rest = awaitChange(rest)
            atWork.toList()
        }.forEach(::giveUp)
    }

    /** Waits for a change, and returns the nanoseconds that are left: none if this thread is interrupted. */
    private fun awaitChange(nanos: Long): Long = try {
        changed.awaitNanos(nanos)
    } catch (_: InterruptedException) {
        Thread.currentThread().interrupt()
        0
    }

    private fun startWorker() {
        active++
        workers += Thread({ run() }, "lazyz-render").apply {
            isDaemon = true
            start()
        }
    }

    private fun run() {
        while (true) {
            val job = next() ?: break
            val outcome = try {
                outcome(job)
            } catch (more: MoreMemory) {
                if (retry(job, more.need)) continue
                QueuedJob.Outcome(null, CLOSED)
            }
            val goesOn = lock.withLock {
                val goesOn = leave(job)
                if (!job.isGivenUp) taken += if (job.reason == null) outcome.picture?.memory ?: 0 else 0
                goesOn
            }
            quietly { job.released() }
            val final = if (job.reason == null) outcome else QueuedJob.Outcome(null, job.reason)
            if (!job.isGivenUp) quietly { job.ended(final) }
            if (!goesOn) break
        }
        lock.withLock {
            workers -= Thread.currentThread()
            changed.signalAll()
        }
    }

    /** Puts [job] in front of all others, to begin again with [need] bytes, unless it must end. */
    private fun retry(job: QueuedJob, need: Long): Boolean = lock.withLock {
        if (isClosed || job.reason != null) return false
        leave(job)
        job.need = need
        jobs.addFirst(job)
        true
    }

    private fun stop(job: QueuedJob, reason: Problem) {
        job.reason = reason
        job.thread?.interrupt()
    }

    /** Ends [job], whose thread does not react, and starts another thread in its place, if there may be one. */
    private fun giveUp(job: QueuedJob) {
        lock.withLock {
            if (!atWork.remove(job)) return
            job.isGivenUp = true
            job.thread?.interrupt()
            active--
            hanging++
            hangingMemory += job.need
            if (hanging <= threads && !isClosed) startWorker()
            changed.signalAll()
        }
        quietly { job.ended(QueuedJob.Outcome(null, job.reason)) }
    }

    private fun drop(job: QueuedJob, reason: Problem) {
        quietly { job.released() }
        quietly { job.ended(QueuedJob.Outcome(null, reason)) }
    }

    /**
     * Takes its thread and its memory from [job]. No interrupt for it comes after this. Returns whether this thread is
     * needed further: one that was given up may have been replaced.
     */
    private fun leave(job: QueuedJob): Boolean {
        job.thread = null
        Thread.interrupted()
        taken -= job.need
        changed.signalAll()
        if (atWork.remove(job)) return true
        hanging--
        hangingMemory -= job.need
        if (active >= threads) return false
        active++
        return true
    }

    /** Returns the first job, as soon as there is memory for it, or null if the queue is closed. */
    private fun next(): QueuedJob? = lock.withLock {
        while (!isClosed) {
            val first = jobs.firstOrNull()
            if (first != null && first.need <= memory - taken) {
                jobs.removeFirst()
                first.thread = Thread.currentThread()
                atWork += first
                taken += first.need
                return first
            }
            changed.awaitUninterruptibly()
        }
        null
    }

    private fun outcome(job: QueuedJob): QueuedJob.Outcome = try {
        job.started()
        QueuedJob.Outcome(job.work(job), null)
    } catch (more: MoreMemory) {
        throw more
    } catch (problem: Problem) {
        QueuedJob.Outcome(null, problem)
    } catch (unreadable: SceneReadException) {
        // Its message can name a path of the server, which is for the log
        QueuedJob.Outcome(null, Problem(Problem.BUG, "the server cannot read a file"), unreadable)
    } catch (invalid: SceneFormatException) {
        // The loader can have met the end of the memory
        val isMemory = generateSequence(invalid.cause) { it.cause }.take(DEEPEST).any { it is OutOfMemoryError }
        QueuedJob.Outcome(null, if (isMemory) MEMORY else Problem(Problem.UNPROCESSABLE, ClientText.of(invalid)))
    } catch (_: InterruptedException) {
        QueuedJob.Outcome(null, CLOSED)
    } catch (_: OutOfMemoryError) {
        QueuedJob.Outcome(null, MEMORY)
    } catch (bug: Throwable) {
        QueuedJob.Outcome(null, Problem(Problem.BUG, "the server has failed: this is a bug"), bug)
    }

    /** Calls [act]. A failure in it must not end a thread of the queue. */
    private fun quietly(act: () -> Unit) = try {
        act()
    } catch (failure: Throwable) {
        LOGGER.log(System.Logger.Level.ERROR, "a request could not be ended", failure)
    }

    private companion object {
        val CLOSED = Problem(Problem.UNAVAILABLE, "the server is closed")
        val MEMORY = Problem(Problem.UNAVAILABLE, "the memory is used up; try a smaller model or picture")
        val LOGGER: System.Logger = System.getLogger("dev.lazyz.server")

        /** The time that [close] waits for threads, at most. */
        val LAST_WAIT: Duration = Duration.ofSeconds(2)

        /** Causes that are looked at. */
        const val DEEPEST = 20
    }
}

/**
 * A rendering that waits for its turn in a [RenderQueue].
 *
 * @param need bytes of memory that it takes, as far as it is known before the work
 * @param work renders the picture. It runs on a thread of the queue, which is interrupted if the job is cancelled. It
 *   is done again with more memory if it throws [MoreMemory]
 * @param started is called when the work begins, on the thread of the queue
 * @param released is called once, when no thread is at work any more
 * @param ended is called once, with the picture or the problem: after that, or, if the queue gives up, before it
 */
internal class QueuedJob(
    need: Long,
    val work: (QueuedJob) -> RenderedPicture,
    val started: () -> Unit,
    val released: () -> Unit,
    val ended: (Outcome) -> Unit,
) {
    /**
     * The result: one of the two is null. The memory of the picture stays reserved; give it back to the queue when the
     * picture has been sent.
     */
    class Outcome(val picture: RenderedPicture?, val problem: Problem?, val bug: Throwable? = null)

    /** Bytes of memory that the work takes. Guarded by the lock of the queue; during the work only that changes it. */
    var need: Long = need

    /** The thread that does the work, or null. Guarded by the lock of the queue. */
    var thread: Thread? = null

    /** Why the job was cancelled, or null. Written under the lock of the queue, while the job is at work. */
    @Volatile
    var reason: Problem? = null

    /** Whether the queue has given up on the job: it has ended, and its thread hangs. As [reason]. */
    @Volatile
    var isGivenUp = false
}

/** The work of a job needs [need] bytes of memory, more than are free: it ends, and begins again when they are. */
internal class MoreMemory(val need: Long) : RuntimeException(null, null, false, false)
