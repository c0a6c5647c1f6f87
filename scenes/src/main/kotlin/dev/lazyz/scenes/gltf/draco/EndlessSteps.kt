package dev.lazyz.scenes.gltf.draco

import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Gives up on a step that does not end. Java cannot end a thread, so that a step given up goes on in the background at the
 * lowest priority, which does not keep a program from ending; while a few of them go on, no further step is begun.
 */
internal class EndlessSteps(private val most: Int) {
    private val givenUp = ArrayList<Thread>()

    /**
     * Returns what [step] returns, or throws what it throws.
     *
     * @throws DracoException if it takes more than [milliseconds], or too many others go on
     */
    fun <T> run(milliseconds: Long, step: () -> T): T {
        if (countGoingOn() >= most) {
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
            synchronized(givenUp) { givenUp.add(thread) }
            thread.priority = Thread.MIN_PRIORITY
            throw DracoException("the compressed data is damaged, or takes more than $milliseconds ms to decode", e)
        } catch (e: InterruptedException) {
            Thread.currentThread().interrupt()
            throw DracoException("the thread was interrupted", e)
        }
    }

    private fun countGoingOn(): Int = synchronized(givenUp) {
        givenUp.removeAll { !it.isAlive }
        givenUp.size
    }
}
