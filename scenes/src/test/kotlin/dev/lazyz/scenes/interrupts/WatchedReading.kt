package dev.lazyz.scenes.interrupts

import java.lang.management.ManagementFactory
import java.util.concurrent.atomic.AtomicReference

/**
 * Reads in a thread of its own, and measures the processor time between two looks at the interrupt: so long can the
 * reading go on after any interrupt.
 *
 * @param interruptAt the look that finds the thread interrupted; none by default
 */
internal class WatchedReading(private val interruptAt: Int = Int.MAX_VALUE, read: () -> Unit) {
    private val failure = AtomicReference<Throwable>()

    /** What ended the reading, or null. */
    val thrown: Throwable? get() = failure.get()

    /** The longest processor time without a look, in nanoseconds, also before the first and after the last one. */
    var longest = 0L
        private set

    /** Where the longest time ended. */
    var place = ""
        private set

    /** Number of looks. */
    var looks = 0
        private set

    /** All of the processor time, in nanoseconds. */
    var total = 0L
        private set
    private var last = 0L

    private val thread = object : Thread({
        try {
            last = time()
            read()
        } catch (e: Throwable) {
            failure.set(e)
        }
        note("the end")
        total = time()
    }) {
        override fun isInterrupted(): Boolean {
            looks++
            val now = time()
            if (now - last > longest) {
                note(StackWalker.getInstance().walk { frames -> frames.skip(2).limit(5).toList() }.joinToString(" < "))
            }
            last = time()
            return looks >= interruptAt
        }
    }

    private fun note(where: String) {
        val now = time()
        if (now - last > longest) {
            longest = now - last
            place = where
        }
    }

    private fun time(): Long = ManagementFactory.getThreadMXBean().currentThreadCpuTime

    init {
        thread.start()
        thread.join()
    }
}
