package dev.lazyz.cli.output

import java.io.Console
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * The three standard streams, and which of them are terminals.
 *
 * @property messages standard error, for errors, warnings and progress
 * @property now a clock, nanoseconds
 * @param isTerminal whether the stream with this number, 1 or 2, is a terminal; called only when needed
 */
internal class Streams(
    val input: InputStream,
    output: OutputStream,
    val messages: PrintStream,
    val now: () -> Long = System::nanoTime,
    isTerminal: (Int) -> Boolean = { false },
) {
    /** Whether standard output is a terminal. zcli does not write a picture to a terminal. */
    val isOutputTerminal: Boolean by lazy { isTerminal(1) }

    /** Whether no progress is printed: not to a terminal, and not by [beat]. */
    var isQuiet: Boolean = false

    private val isMessageTerminal: Boolean by lazy { isTerminal(2) }
    private val start = now()

    /** What is done at the moment, or nothing. */
    @Volatile
    private var state = ""

    /** Standard output. Writing throws [OutputClosed] if it is a pipe whose reader has closed it. */
    val output: OutputStream = StandardOutput(output)

    /** The message that stands on the terminal. */
    private val progress = StringBuilder()

    /** Prints text to standard output, in UTF-8. */
    fun print(text: String) {
        clearProgress()
        output.write(text.toByteArray())
    }

    fun error(message: String) {
        clearProgress()
        messages.println("zcli: error: $message")
    }

    fun warning(message: String) {
        clearProgress()
        messages.println("zcli: warning: $message")
    }

    /** Warns of [message], about [what] if there are several pictures. */
    fun warning(what: String?, message: String) = warning((if (what == null) "" else "$what: ") + message)

    /** Prints text to standard error without a prefix. */
    fun note(text: String) {
        clearProgress()
        messages.print(text)
    }

    /** Prints a line to standard error if it is a terminal. */
    fun remark(message: String) {
        if (isQuiet || !isMessageTerminal) return
        clearProgress()
        messages.println(message)
    }

    /** Says what is done now: shows [message] on the terminal, if there is one, instead of the previous one. */
    fun progress(message: String) {
        state = message
        if (isQuiet || !isMessageTerminal) return
        clearProgress()
        progress.append(message)
        messages.print(message)
        messages.flush()
    }

    /** Prints a line with the latest message of [progress], unless a terminal shows it. Thread safe. */
    fun beat() {
        val message = state
        if (isQuiet || message.isEmpty() || isMessageTerminal) return
        messages.println("zcli: after ${Progress.duration((now() - start) / NANOSECONDS)}: $message")
    }

    private fun clearProgress() {
        if (progress.isEmpty()) return
        messages.print("\r" + " ".repeat(progress.length) + "\r")
        progress.clear()
    }

    fun flushMessages() {
        clearProgress()
        messages.flush()
    }

    companion object {
        /**
         * Returns the streams of the process. Does not write to a [PrintStream], because that would hide a closed pipe.
         */
        fun ofProcess(): Streams = Streams(
            System.`in`,
            FileOutputStream(FileDescriptor.out).buffered(),
            System.err,
            isTerminal = { isTerminal(it) && (it == 1 || System.getenv("TERM") != "dumb") },
        )

        /**
         * Returns whether [descriptor] is a terminal. Java has no method for a single stream. On Unix, a character
         * device counts as a terminal unless it is one of [others]; elsewhere, both are terminals or none is.
         */
        private fun isTerminal(descriptor: Int): Boolean = try {
            val mode = Files.getAttribute(Path.of("/dev/fd/$descriptor"), "unix:mode") as Int
            val isCharacterDevice = mode and FILE_TYPE == CHARACTER_DEVICE
            isCharacterDevice && others.none { isSameDevice("/dev/fd/$descriptor", it) }
        } catch (unknown: IOException) {
            false
        } catch (notUnix: UnsupportedOperationException) {
            System.console()?.let { isTerminal(it) } == true
        }

        /** From Java 22 on, there is a console even without a terminal, and a method that tells. */
        private fun isTerminal(console: Console): Boolean = try {
            Console::class.java.getMethod("isTerminal").invoke(console) as Boolean
        } catch (old: NoSuchMethodException) {
            true
        }

        private fun isSameDevice(first: String, second: String): Boolean {
            val (a, b) = listOf(first, second).map { Path.of(it) }
            return Files.exists(b) && Files.getAttribute(a, "unix:rdev") == Files.getAttribute(b, "unix:rdev")
        }

        private val others = listOf("/dev/null", "/dev/full", "/dev/zero")
        private const val NANOSECONDS = 1_000_000_000L
        private const val FILE_TYPE = 0xF000
        private const val CHARACTER_DEVICE = 0x2000
    }
}

/** Standard output is a pipe, and its reader has closed it. */
internal class OutputClosed(cause: IOException) : RuntimeException("standard output is closed", cause)

/** Distinguishes a closed pipe, which is not an error, from errors such as a full disk. */
private class StandardOutput(private val target: OutputStream) : OutputStream() {
    override fun write(byte: Int) = guarded { target.write(byte) }

    override fun write(bytes: ByteArray, offset: Int, length: Int) = guarded { target.write(bytes, offset, length) }

    override fun flush() = guarded { target.flush() }

    /** Only flushes: standard output stays open until the process ends. */
    override fun close() = flush()

    private inline fun guarded(write: () -> Unit) {
        try {
            write()
        } catch (failure: IOException) {
            if (failure.message.orEmpty().contains("pipe", ignoreCase = true)) throw OutputClosed(failure)
            throw Mistake("cannot write to standard output: ${failure.message}")
        }
    }
}
