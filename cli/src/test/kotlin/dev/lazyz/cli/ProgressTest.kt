package dev.lazyz.cli

import dev.lazyz.cli.output.Heartbeat
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams
import java.io.ByteArrayOutputStream
import java.io.InputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicLong
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class ProgressTest {
    @TempDir
    lateinit var folder: Path

    private val errors = ByteArrayOutputStream()
    private val time = AtomicLong()

    private fun streams(isTerminal: Boolean, now: () -> Long = time::get) =
        Streams(InputStream.nullInputStream(), OutputStream.nullOutputStream(), PrintStream(errors), now) {
            it == 2 && isTerminal
        }

    private val shown get() = errors.toString().split(Regex("[\r\n]")).map { it.trim() }.filter { it.isNotEmpty() }

    private fun pass(milliseconds: Long) {
        time.addAndGet(milliseconds * 1_000_000)
    }

    @Test
    fun speedAndTimeLeftAreShownWhenEnoughIsKnown() {
        val progress = Progress(streams(isTerminal = true), 4000, "rows")

        // Set-up belongs to the first row only
        pass(60_000)
        repeat(3) {
            progress.advance()
            pass(500)
        }
        repeat(997) { progress.advance() }
        pass(8_500)
        progress.advance()
        assertEquals(
            listOf(
                "1 of 4,000 rows (0 %)", "2 of 4,000 rows (0 %)", "3 of 4,000 rows (0 %)", "4 of 4,000 rows (0 %)",
                "1,001 of 4,000 rows (25 %), 100 rows/s, 29 s left",
            ),
            shown,
        )
    }

    /** The first of 100 bands takes longer than the others: an estimate from it would be an hour for a minute. */
    @Test
    fun theFirstEstimateIsNearTheTruth() {
        val progress = Progress(streams(isTerminal = true), 1000, "rows", "shadows")
        pass(30_000)
        repeat(100) {
            repeat(10) { progress.advance() }
            pass(600)
        }
        val first = shown.first { "left" in it }
        assertEquals("shadows: 41 of 1,000 rows (4 %), 17 rows/s, 57 s left", first)
    }

    @Test
    fun longWorkWithoutATerminalPrintsALineEveryTenSeconds() {
        val streams = streams(isTerminal = false)
        var waits = 0
        val heartbeat = Heartbeat(streams) { seconds ->
            if (waits++ == 3) throw IllegalStateException("enough")
            streams.progress("work $waits")
            pass(seconds * 1000)
        }
        assertThrows(IllegalStateException::class.java) { heartbeat.run() }
        assertEquals(
            "zcli: after 10 s: work 1\nzcli: after 20 s: work 2\nzcli: after 30 s: work 3\n", errors.toString(),
        )
    }

    @Test
    fun aTerminalOrAQuietRunHasNoHeartbeat() {
        val terminal = streams(isTerminal = true)
        terminal.progress("work")
        errors.reset()
        terminal.beat()
        val quiet = streams(isTerminal = false)
        quiet.isQuiet = true
        quiet.progress("work")
        quiet.beat()
        streams(isTerminal = false).beat()
        assertEquals("", errors.toString())
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

    @Test
    fun quietRunsPrintNothingToATerminal() {
        val picture = arrayOf("--size", "9x9", "-o", "$folder/a.png", "--quiet")
        for (args in listOf(
            arrayOf("render", "teapot", *picture), arrayOf("trace", "teapot", *picture, "--steps", "2"),
            arrayOf("report", "teapot", "--strategy", "lazy", "--size", "9x9", "--quiet", "-o", "$folder/a.html"),
            arrayOf("compare", "teapot", "--size", "9x9", "--quiet"),
        )) {
            assertEquals(0, run(args, streams(isTerminal = true)))
            assertEquals("", errors.toString(), args[0])
        }
    }

    /** A clock that moves by a second each time makes each step of the progress visible. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun shadowsHaveAPercentage() {
        val streams = streams(isTerminal = true) { time.addAndGet(1_000_000_000) }
        val shadows = arrayOf("--ambient-occlusion", "--ground-shadow", "--size", "9x9", "--threads", "1")
        assertEquals(0, run(arrayOf("render", "${folder.wedge()}", *shadows, "-o", "$folder/a.png"), streams))
        for (part in listOf("shadows: 1 of 192 directions (0 %)", "shadows: 192 of 192 directions (100 %), 1.0")) {
            assertTrue(shown.any { it.startsWith(part) }) { "$part: $shown" }
        }
    }
}
