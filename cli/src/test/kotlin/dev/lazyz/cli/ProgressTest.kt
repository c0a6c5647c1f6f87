package dev.lazyz.cli

import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams
import java.io.ByteArrayOutputStream
import java.io.InputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class ProgressTest {
    @TempDir
    lateinit var folder: Path

    private val errors = ByteArrayOutputStream()

    private fun streams(isTerminal: Boolean) =
        Streams(InputStream.nullInputStream(), OutputStream.nullOutputStream(), PrintStream(errors)) {
            it == 2 &&
                isTerminal
        }

    private val shown get() = errors.toString().split(Regex("[\r\n]")).map { it.trim() }.filter { it.isNotEmpty() }

    @Test
    fun partsRateAndTimeLeftAreShown() {
        var time = 0L
        val progress = Progress(streams(isTerminal = true), 4000, "rows") { time }
        repeat(3) {
            time += 500_000_000
            progress.advance()
        }
        repeat(997) { progress.advance() }
        time = 10_000_000_000
        progress.advance()
        assertEquals(
            listOf(
                "1 of 4,000 rows (0 %), 2.0 rows/s, 33 min 19 s left",
                "2 of 4,000 rows (0 %), 2.0 rows/s, 33 min 19 s left",
                "3 of 4,000 rows (0 %), 2.0 rows/s, 33 min 18 s left",
                "1,001 of 4,000 rows (25 %), 100 rows/s, 29 s left",
            ),
            shown,
        )
    }

    @Test
    fun picturesOfABatchAreCountedOnATerminalOnly() {
        val args = arrayOf("render", "teapot", "city", "--size", "9x9", "--turntable", "8", "-o", "$folder/{stem}.png")
        assertEquals(0, run(args, streams(isTerminal = true)))
        assertTrue(shown.any { Regex("wrote .*teapot\\.png").matches(it) }) { "$shown" }
        errors.reset()
        assertEquals(0, run(args, streams(isTerminal = false)))
        assertEquals("", errors.toString())
    }
}
