package dev.lazyz.scenes.fuzz

import com.sun.management.ThreadMXBean
import java.lang.management.ManagementFactory

/**
 * Runs one input after the other, and looks at what it takes. Not thread safe, but that another thread may ask [hang].
 */
internal class CaseRunner(private val case: SceneCase) {
    private val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean

    /** The input at hand; null between inputs. */
    @Volatile
    private var current: ByteArray? = null

    @Volatile
    private var since = 0L

    /**
     * What became of an input.
     *
     * @property isScene whether it was loaded
     * @property fault what must not be, or null
     * @property kind faults with the same are one finding
     */
    class Outcome(val isScene: Boolean, val fault: String? = null, val kind: String = "", val trace: String = "")

    fun run(bytes: ByteArray): Outcome {
        since = System.nanoTime()
        current = bytes
        return try {
            watched(bytes)
        } catch (e: Throwable) {
            thrown(e)
        } finally {
            current = null
        }
    }

    /** Returns the input at hand and what is wrong if it takes so long that it is to be given up; [worker] has it. */
    fun hang(worker: Thread): Pair<ByteArray, Outcome>? {
        val input = current ?: return null
        if (System.nanoTime() - since < MOST_SECONDS * 1000 * NANOS_PER_MILLI) return null
        val stack = worker.stackTrace.joinToString("\n") { "\tat $it" }
        return input to Outcome(false, "takes more than $MOST_SECONDS s", "hang", stack)
    }

    private fun watched(bytes: ByteArray): Outcome {
        val id = Thread.currentThread().id
        val memory = threads.getThreadAllocatedBytes(id)
        val loaded = case.load(bytes)
        val taken = threads.getThreadAllocatedBytes(id) - memory
        case.draw()
        val message = loaded.messages.firstOrNull { text -> text.any { it.isISOControl() } }
        val isSlow = System.nanoTime() - since > MOST_MILLIS * NANOS_PER_MILLI
        val millis = if (isSlow) millisAgain(bytes, id) else 0
        return when {
            taken > MOST_MEMORY -> Outcome(loaded.isScene, "allocates ${taken shr 20} MiB to load", "memory")
            millis > MOST_MILLIS -> Outcome(loaded.isScene, "takes $millis ms to load and draw", "time")
            message != null -> Outcome(loaded.isScene, "a message has control characters: $message", "message")
            else -> Outcome(loaded.isScene)
        }
    }

    /**
     * Returns what an input takes of a processor, which a busy machine does not change; to ask for it each time is
     * slow.
     */
    private fun millisAgain(bytes: ByteArray, thread: Long): Long {
        val time = threads.getThreadCpuTime(thread)
        case.load(bytes)
        case.draw()
        return (threads.getThreadCpuTime(thread) - time) / NANOS_PER_MILLI
    }

    private fun thrown(error: Throwable): Outcome {
        val trace = error.stackTraceToString().lineSequence().take(MOST_LINES).joinToString("\n")
        val place = error.stackTrace.firstOrNull { it.className.startsWith("dev.lazyz.") }
        val where = if (error is StackOverflowError) "" else " at $place"
        return Outcome(false, error.toString().take(MOST_TEXT), error.javaClass.simpleName + where, trace)
    }

    private companion object {
        /** After which an input is given up. */
        const val MOST_SECONDS = 300L

        /** By the clock, and then of a processor's time. */
        const val MOST_MILLIS = 2000L

        /** Of all inputs, which are below 100 KB and have a limit of 8 MiB. */
        const val MOST_MEMORY = 256L shl 20
        const val NANOS_PER_MILLI = 1_000_000L
        const val MOST_LINES = 60
        const val MOST_TEXT = 500
    }
}
