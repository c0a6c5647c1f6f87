package dev.lazyz.cli

import java.io.PrintStream

/**
 * Reports the exceptions that end threads other than the main one to [messages], as Java does, except that memory is
 * used up: the thread was helping, and the one that it helped does the work, or fails and reports it.
 */
internal class ThreadEnd(private val messages: PrintStream) : Thread.UncaughtExceptionHandler {
    init {
        // The first call of a method needs memory, which is not there when it matters
        uncaughtException(Thread.currentThread(), OutOfMemoryError())
    }

    override fun uncaughtException(thread: Thread, failure: Throwable) {
        if (failure is OutOfMemoryError) return
        messages.print("Exception in thread \"${thread.name}\" ")
        failure.printStackTrace(messages)
    }
}
