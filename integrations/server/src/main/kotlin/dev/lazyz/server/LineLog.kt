package dev.lazyz.server

import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong
import java.util.function.Consumer

/**
 * Passes lines to [consumer], without control characters, on a thread of its own: if it is slow, because nobody reads
 * the output of the process, requests do not wait for it. Lines that are too many meanwhile are dropped and counted.
 */
internal class LineLog(private val consumer: Consumer<String>) : AutoCloseable {
    private val lines = LinkedBlockingQueue<String>(CAPACITY)
    private val dropped = AtomicLong()

    @Volatile
    private var isClosed = false
    private val thread = Thread({ run() }, "lazyz-log").apply {
        isDaemon = true
        start()
    }

    fun add(line: String) {
        if (!lines.offer(line)) dropped.incrementAndGet()
    }

    /** Waits a moment until all lines are written. */
    override fun close() {
        isClosed = true
        thread.join(LAST_LINES)
    }

    private fun run() {
        while (true) {
            val line = lines.poll(PERIOD, TimeUnit.MILLISECONDS)
            if (line == null && isClosed) return
            if (line != null) write(line)
            val lost = dropped.getAndSet(0)
            if (lost > 0) write("$lost lines of the log were dropped, since it is too slow")
        }
    }

    /** A log that fails does not stop the work. */
    private fun write(line: String) = try {
        consumer.accept(line.map { if (it in ' '..'~') it else '?' }.joinToString(""))
    } catch (failure: RuntimeException) {
        LOGGER.log(System.Logger.Level.ERROR, "a line of the log could not be written: $line", failure)
    }

    private companion object {
        const val CAPACITY = 10_000

        /** Milliseconds. */
        const val PERIOD = 50L
        const val LAST_LINES = 1000L
        val LOGGER: System.Logger = System.getLogger("dev.lazyz.server")
    }
}
