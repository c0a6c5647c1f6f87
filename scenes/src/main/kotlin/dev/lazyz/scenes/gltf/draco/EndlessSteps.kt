package dev.lazyz.scenes.gltf.draco

import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Runs steps with a time limit. Java cannot stop a thread, so an abandoned step continues in the background, in a
 * daemon thread of the lowest priority. While the maximum number of abandoned steps are running, no further step is
 * started.
 *
 * @param most maximum number of abandoned steps that are still running
 */
internal class EndlessSteps(private val most: Int) {
    private val abandoned = ArrayList<Thread>()

    /**
     * Returns what [step] returns, or throws what it throws.
     *
     * @throws DracoException if the step takes more than [milliseconds], if too many abandoned steps are still running,
     *   or if the calling thread is interrupted
     */
    fun <T> run(milliseconds: Long, step: () -> T): T {
        if (countRunning() >= most) {
            throw DracoException("the decoder is still busy with damaged data; start the program again")
        }
        val task = FutureTask(step)
        val thread = Thread(task, "lazyz-draco")
        thread.isDaemon = true
        thread.start()
        try {
            return task.get(milliseconds, TimeUnit.MILLISECONDS)
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } catch (e: TimeoutException) {
            abandon(thread)
            throw DracoException("the compressed data is damaged, or takes more than $milliseconds ms to decode", e)
        } catch (e: InterruptedException) {
            abandon(thread)
            Thread.currentThread().interrupt()
            throw DracoException("the thread was interrupted", e)
        }
    }

    private fun abandon(thread: Thread) {
        synchronized(abandoned) { abandoned.add(thread) }
        thread.priority = Thread.MIN_PRIORITY
    }

    private fun countRunning(): Int = synchronized(abandoned) {
        abandoned.removeAll { !it.isAlive }
        abandoned.size
    }
}
