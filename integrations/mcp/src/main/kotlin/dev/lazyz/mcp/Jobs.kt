package dev.lazyz.mcp

import dev.lazyz.scenes.ClientText
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.util.concurrent.FutureTask
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit
import reactor.core.publisher.Mono

/** What was asked for is not possible. The message says why, in words for the client. */
internal class Refusal(message: String) : RuntimeException(message, null, false, false)

internal fun refuse(message: String): Nothing = throw Refusal(message)

/**
 * Does one job at a time, each with all processors and all memory, in the order in which they come. Thread safe.
 *
 * @param seconds time of a job on the wall
 */
internal class Jobs(private val seconds: Long) {
    private val worker = ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, LinkedBlockingQueue(MOST_WAITING)) {
        Thread(it, "lazyz-job").apply { isDaemon = true }
    }
    private val watch = ScheduledThreadPoolExecutor(1) { Thread(it, "lazyz-watch").apply { isDaemon = true } }

    /**
     * Returns what [work] gives or, when it fails or takes too long, what [failed] makes of the reason. The work begins
     * with the subscription. If that is cancelled, it is interrupted.
     */
    fun <T : Any> run(failed: (String) -> T, work: () -> T): Mono<T> = Mono.create { sink ->
        lateinit var job: FutureTask<Unit>
        job = FutureTask {
            val tooLong = Runnable {
                sink.success(failed("this takes more than $seconds s; choose a smaller picture, aa or model"))
                job.cancel(true)
            }
            val alarm = watch.schedule(tooLong, seconds, TimeUnit.SECONDS)
            val result = try {
                work()
            } catch (failure: Throwable) {
                failed(text(failure))
            } finally {
                alarm.cancel(false)
            }
            Thread.interrupted()
            sink.success(result)
        }
        sink.onCancel {
            job.cancel(true)
            worker.remove(job)
        }
        try {
            worker.execute(job)
        } catch (_: RejectedExecutionException) {
            sink.success(failed("too many requests wait; try again later"))
        }
    }

    private fun text(failure: Throwable): String {
        val causes = generateSequence(failure) { it.cause }.take(DEEPEST)
        return when {
            causes.any { it is OutOfMemoryError } -> "the memory is used up; try a smaller model or picture"
            failure is Refusal -> failure.message.orEmpty()
            failure is SceneReadException -> "${failure.source}: the file cannot be read"
            failure is SceneFormatException -> ClientText.of(failure)
            failure is IllegalArgumentException -> ClientText.of(failure.message.orEmpty())
            failure is InterruptedException -> "it was cancelled"
            else -> "the server has failed: this is a bug".also { failure.printStackTrace() }
        }
    }

    private companion object {
        /** Jobs that wait; as for `lazyz-server`. */
        const val MOST_WAITING = 64

        /** Causes that are looked at. */
        const val DEEPEST = 20
    }
}
