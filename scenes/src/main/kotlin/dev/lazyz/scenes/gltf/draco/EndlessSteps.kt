package dev.lazyz.scenes.gltf.draco

import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.concurrent.atomic.AtomicInteger

/**
 * Gives up on a step that does not end. Java cannot end a thread, so that a step given up goes on in the background at the
 * lowest priority, which does not keep a program from ending; after a few of them no further step is begun.
 */
internal class EndlessSteps(private val most: Int) {
    private val givenUp = AtomicInteger()

    /**
     * Returns what [step] returns, or throws what it throws.
     *
     * @throws DracoException if it takes more than [milliseconds], or too many others go on
     */
    fun <T> run(milliseconds: Long, step: () -> T): T {
        if (givenUp.get() >= most) {
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
            givenUp.incrementAndGet()
            thread.priority = Thread.MIN_PRIORITY
            throw DracoException("the compressed data is damaged, or takes more than $milliseconds ms to decode", e)
        } catch (e: InterruptedException) {
            Thread.currentThread().interrupt()
            throw DracoException("the thread was interrupted", e)
        }
    }
}
