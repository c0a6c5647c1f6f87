package dev.lazyz.cli.output

import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * The three standard streams, and which of them a person is looking at.
 *
 * @property messages standard error, for errors, warnings and progress
 * @param isTerminal whether the stream with this number, 1 or 2, is a terminal; asked only when it matters
 */
internal class Streams(
    val input: InputStream,
    output: OutputStream,
    val messages: PrintStream,
    isTerminal: (Int) -> Boolean = { false },
) {
    /** Whether standard output is a terminal, where the bytes of a picture would do harm. */
    val isOutputTerminal: Boolean by lazy { isTerminal(1) }

    /** Whether standard error is a terminal, where progress is welcome. */
    private val isProgressWelcome: Boolean by lazy { isTerminal(2) }

    /** Standard output. When nobody reads it any more, writing throws [OutputClosed]. */
    val output: OutputStream = StandardOutput(output)

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

    fun nothingIsVisible() = warning("nothing is visible: the picture is all background")

    /** Prints text that was asked for to standard error. */
    fun note(text: String) {
        clearProgress()
        messages.print(text)
    }

    /** Prints a line to standard error if somebody sees it. */
    fun remark(message: String) {
        if (!isProgressWelcome) return
        clearProgress()
        messages.println(message)
    }

    /** Shows on the terminal, if there is one, what is going on; replaces what was shown before. */
    fun progress(message: String) {
        if (!isProgressWelcome) return
        clearProgress()
        progress.append(message)
        messages.print(message)
        messages.flush()
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
        /** The process's own streams. Standard output is not a [PrintStream], for that would hide a closed pipe. */
        fun ofProcess(): Streams = Streams(
            System.`in`,
            FileOutputStream(FileDescriptor.out).buffered(),
            System.err,
            { isTerminal(it) && (it == 1 || System.getenv("TERM") != "dumb") },
        )

        /** Java does not tell which stream is a terminal; a character device that is no usual other is one. */
        private fun isTerminal(descriptor: Int): Boolean = try {
            val mode = Files.getAttribute(Path.of("/dev/fd/$descriptor"), "unix:mode") as Int
            val isCharacterDevice = mode and FILE_TYPE == CHARACTER_DEVICE
            isCharacterDevice && others.none { isSameDevice("/dev/fd/$descriptor", it) }
        } catch (unknown: IOException) {
            false
        } catch (notUnix: UnsupportedOperationException) {
            System.console() != null
        }

        private fun isSameDevice(first: String, second: String): Boolean {
            val (a, b) = listOf(first, second).map { Path.of(it) }
            return Files.exists(b) && Files.getAttribute(a, "unix:rdev") == Files.getAttribute(b, "unix:rdev")
        }

        private val others = listOf("/dev/null", "/dev/full", "/dev/zero")
        private const val FILE_TYPE = 0xF000
        private const val CHARACTER_DEVICE = 0x2000
    }
}

/** Standard output is a pipe whose reader has gone. */
internal class OutputClosed(cause: IOException) : RuntimeException("standard output is closed", cause)

/** Tells a closed pipe, which is nobody's fault, from a full disk. */
private class StandardOutput(private val target: OutputStream) : OutputStream() {
    override fun write(byte: Int) = guarded { target.write(byte) }

    override fun write(bytes: ByteArray, offset: Int, length: Int) = guarded { target.write(bytes, offset, length) }

    override fun flush() = guarded { target.flush() }

    /** Standard output belongs to the process: whoever closes a writer on top of it only flushes it. */
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
