package dev.lazyz.cli

import dev.lazyz.Raster
import dev.lazyz.zbuffer.ZBuffer
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SmallPartsTest {
    @Test
    fun nearestToleratesAThirdOfTheLetters() {
        val names = listOf("teapot", "city", "molecule", "layers")
        for (typo in listOf("teapto", "taepot", "TEAPOT", "tepot", "teapott", "teap", "tea")) {
            assertEquals("teapot", Nearest.of(typo, names), typo)
        }
        assertEquals("city", Nearest.of("cty", names))
        assertEquals("molecule", Nearest.of("mol", names))
        for (other in listOf("", "x", "te", "bunny", "teapot-on-a-table")) assertNull(Nearest.of(other, names), other)
        assertNull(Nearest.of("x", listOf("y", "z")))
        assertNull(Nearest.of("teapot", listOf()))
    }

    @Test
    fun bytesAreReadable() {
        val expected = mapOf(
            0L to "0 bytes",
            1023L to "1023 bytes",
            1024L to "1.0 KiB",
            3_686_400L to "3.5 MiB",
            12L shl 36 to "768.0 GiB",
            Long.MAX_VALUE / 16 to "524287.9 TiB",
        )
        for ((bytes, text) in expected) assertEquals(text, Bytes.readable(bytes))
    }

    @Test
    fun memoryIsEstimatedBeforeItIsNeeded() {
        MemoryNeed.check(ZBuffer(), Raster(100, 100), available = 120_000)
        val larger = Raster(100, 101)
        val mistake = assertThrows(Mistake::class.java) { MemoryNeed.check(ZBuffer(), larger, available = 120_000) }
        val parts = listOf("100x101", "'zbuffer'", "118.3 KiB", "117.1 KiB", "-Xmx2g")
        assertEquals(parts, parts.filter { it in mistake.message.orEmpty() }, mistake.message)
        MemoryNeed.check(BuggyRenderer(), Raster(262_144, 262_144), available = 1)
    }

    @Test
    fun progressIsShownOnTerminalsAndWipedOut() {
        val shown = ByteArrayOutputStream()
        val messages = PrintStream(shown, true)
        val terminal = Streams("".byteInputStream(), ByteArrayOutputStream(), messages) { it == 2 }
        terminal.progress("one")
        terminal.progress("two")
        terminal.warning("three")
        assertEquals("one\r   \rtwo\r   \rzcli: warning: three\n", shown.toString())
        shown.reset()
        assertEquals(0, run(arrayOf("render", "teapot", "-o", "-", "--size", "4x3"), terminal))
        assertTrue("reading teapot" in shown.toString() && shown.toString().endsWith(" \r"), shown.toString())
    }

    @Test
    fun picturesAreNotWrittenToATerminal() {
        val shown = ByteArrayOutputStream()
        val screen = ByteArrayOutputStream()
        val terminal = Streams("".byteInputStream(), screen, PrintStream(shown, true)) { it == 1 }
        assertEquals(2, run(arrayOf("render", "teapot", "-o", "-"), terminal))
        assertTrue("would confuse the terminal" in shown.toString())
        assertEquals(0, screen.size())
    }
}
