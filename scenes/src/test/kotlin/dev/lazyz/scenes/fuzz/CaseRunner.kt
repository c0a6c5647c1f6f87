package dev.lazyz.scenes.fuzz

import com.sun.management.ThreadMXBean
import java.lang.management.ManagementFactory
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** Runs one input after the other on a thread of its own, and looks at what it takes. Not thread safe. */
internal class CaseRunner(private val case: SceneCase) : AutoCloseable {
    private lateinit var worker: Thread
    private val executor = Executors.newSingleThreadExecutor { task ->
        Thread(task, "fuzz").also {
            it.isDaemon = true
            worker = it
        }
    }
    private val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean

    /** Whether an input never came back, and has the thread. */
    var hangs = false
        private set

    /**
     * What became of an input.
     *
     * @property isScene whether it was loaded
     * @property fault what must not be, or null
     * @property kind faults with the same are one finding
     */
    class Outcome(val isScene: Boolean, val fault: String? = null, val kind: String = "", val trace: String = "")

    fun run(bytes: ByteArray): Outcome {
        val task = executor.submit<Outcome> { watched(bytes) }
        return try {
            task.get(MOST_SECONDS, TimeUnit.SECONDS)
        } catch (_: TimeoutException) {
            hangs = true
            val stack = worker.stackTrace.joinToString("\n") { "\tat $it" }
            Outcome(false, "takes more than $MOST_SECONDS s", "hang", stack)
        } catch (e: ExecutionException) {
            thrown(checkNotNull(e.cause))
        }
    }

    private fun watched(bytes: ByteArray): Outcome {
        val id = Thread.currentThread().id
        val memory = threads.getThreadAllocatedBytes(id)
        val time = threads.getThreadCpuTime(id)
        val loaded = case.load(bytes)
        val taken = threads.getThreadAllocatedBytes(id) - memory
        case.draw()
        val millis = (threads.getThreadCpuTime(id) - time) / 1_000_000
        val message = loaded.messages.firstOrNull { text -> text.any { it.isISOControl() } }
        return when {
            taken > MOST_MEMORY -> Outcome(loaded.isScene, "allocates ${taken shr 20} MiB to load", "memory")
            millis > MOST_MILLIS -> Outcome(loaded.isScene, "takes $millis ms to load and draw", "time")
            message != null -> Outcome(loaded.isScene, "a message has control characters: $message", "message")
            else -> Outcome(loaded.isScene)
        }
    }

    private fun thrown(error: Throwable): Outcome {
        val trace = error.stackTraceToString().lineSequence().take(MOST_LINES).joinToString("\n")
        val place = error.stackTrace.firstOrNull { it.className.startsWith("dev.lazyz.") }
        val where = if (error is StackOverflowError) "" else " at $place"
        return Outcome(false, error.toString().take(MOST_TEXT), error.javaClass.simpleName + where, trace)
    }

    override fun close() {
        executor.shutdown()
    }

    private companion object {
        /** After which an input is given up. */
        const val MOST_SECONDS = 30L

        /** Of a processor's time: this machine may be busy. */
        const val MOST_MILLIS = 2000L

        /** Of all inputs, which are below 100 KB and have a limit of 8 MiB. */
        const val MOST_MEMORY = 256L shl 20
        const val MOST_LINES = 60
        const val MOST_TEXT = 500
    }
}
