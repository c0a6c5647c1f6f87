package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.text.EditDistance
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.painter.PainterRenderer
import dev.lazyz.strategies.scanline.ScanlineRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
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
            assertEquals("teapot", EditDistance.nearest(typo, names), typo)
        }
        assertEquals("city", EditDistance.nearest("cty", names))
        assertEquals("molecule", EditDistance.nearest("mol", names))
        for (other in listOf("", "x", "te", "bunny", "teapot-on-a-table")) {
            assertNull(EditDistance.nearest(other, names), other)
        }
        assertNull(EditDistance.nearest("x", listOf("y", "z")))
        assertNull(EditDistance.nearest("teapot", listOf()))
    }

    @Test
    fun aHelperWithoutMemoryEndsSilently() {
        val errors = ByteArrayOutputStream()
        val handler = ThreadEnd(PrintStream(errors, true))
        handler.uncaughtException(Thread.currentThread(), OutOfMemoryError("Java heap space"))
        assertEquals("", errors.toString())
        handler.uncaughtException(Thread("lazyz-1"), IllegalStateException("the cursor ran away"))
        val start = "Exception in thread \"lazyz-1\" java.lang.IllegalStateException: the cursor ran away\n\tat "
        assertTrue(errors.toString().startsWith(start)) { "$errors" }
    }

    @Test
    fun bytesAreReadable() {
        val expected = mapOf(
            0L to "0 bytes", 1023L to "1023 bytes", 1024L to "1.0 KiB", 3_686_400L to "3.5 MiB",
            12L shl 36 to "768.0 GiB", Long.MAX_VALUE / 16 to "524287.9 TiB",
        )
        for ((bytes, text) in expected) assertEquals(text, Bytes.readable(bytes))
    }

    @Test
    fun bytesAreRead() {
        val expected = mapOf(
            "0" to 0L, "65536" to 65_536L, "100 bytes" to 100L, "7b" to 7L, "64k" to 65_536L, "64K" to 65_536L,
            "1ki" to 1024L, "1 KiB" to 1024L, "16m" to (16L shl 20), "16MiB" to (16L shl 20), "3g" to (3L shl 30),
            "2T" to (2L shl 40), "8388607t" to (8_388_607L shl 40), "8388608t" to Long.MAX_VALUE,
            "99999999999999999999" to Long.MAX_VALUE,
        )
        for ((text, bytes) in expected) assertEquals(bytes, Bytes.parse(text), text)
        for (other in listOf("", "k", "-1", "1.5g", "64kb", "64KB", "1x", "1kk", "0x10", " 1")) {
            assertNull(Bytes.parse(other), other)
        }
    }

    @Test
    fun memoryIsEstimatedBeforeItIsNeeded() {
        Strategies.requireMemory(ZBufferRenderer(), Region(0, 0, 100, 100), available = 120_000)
        val larger = Region(0, 0, 100, 101)
        val mistake =
            assertThrows(Mistake::class.java) {
                Strategies.requireMemory(ZBufferRenderer(), larger, available = 120_000)
            }
        val parts = listOf("100x101", "'zbuffer'", "118.3 KiB", "117.1 KiB", "-Xmx2g")
        assertEquals(parts, parts.filter { it in mistake.message.orEmpty() }, mistake.message)
        Strategies.requireMemory(BuggyRenderer(), Region(0, 0, 262_144, 262_144), available = 1)
    }

    @Test
    fun whoKeepsThePictureIsFoundOutByMeasuring() {
        fun assertNeeds(bytesPerPixel: Long, strategy: Renderer, kept: Long = 0) {
            val picture = Region(0, 0, 1000, 1000)
            val need = (bytesPerPixel + kept) * picture.size
            Strategies.requireMemory(strategy, picture, kept, need)
            assertThrows(Mistake::class.java) { Strategies.requireMemory(strategy, picture, kept, need - 1) }
        }
        assertNeeds(12, ZBufferRenderer())
        assertNeeds(12, HybridRenderer())
        assertNeeds(8, PainterRenderer())
        assertNeeds(12, WrongColorRenderer())
        assertNeeds(0, ScanlineRenderer(), kept = 12)
    }

    @Test
    fun everyBuiltInEitherStreamsOrRefusesWhatCannotFit() {
        val largest = Raster(262_144, 262_144).region
        for (strategy in Renderers.builtIn) {
            if (Capability.CONSTANT_MEMORY in strategy.capabilities) {
                Strategies.requireMemory(strategy, largest)
            } else {
                assertThrows(Mistake::class.java, { Strategies.requireMemory(strategy, largest) }, strategy.id)
            }
        }
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
        assertTrue("cannot write a picture to a terminal" in shown.toString())
        assertEquals(0, screen.size())
    }
}
