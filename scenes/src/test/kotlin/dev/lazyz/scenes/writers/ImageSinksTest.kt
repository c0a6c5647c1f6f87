package dev.lazyz.scenes.writers

import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Image
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32
import javax.imageio.ImageIO
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class ImageSinksTest {
    @TempDir
    lateinit var folder: Path

    private val image = Image(
        3,
        2,
        intArrayOf(0xFF010203.toInt(), 0x80FF00FF.toInt(), 0, 0xFFFFFFFF.toInt(), 0xFF808080.toInt(), 0x10203040),
        intArrayOf(Depth.NEAR, Depth.FAR, Int.MAX_VALUE, Depth.ofUnit(0.25), Depth.ofUnit(0.5), Int.MAX_VALUE),
        intArrayOf(0, 1, DepthTest.BACKGROUND, 2, 3, DepthTest.BACKGROUND),
        Counters.NONE,
    )

    @Test
    fun pngChunksComeInOrderWithTheirCheckSums() {
        val bytes = ByteArrayOutputStream()
        PngSink(bytes, 3, 2).use { image.sendTo(it) }
        val buffer = ByteBuffer.wrap(bytes.toByteArray())
        assertEquals(0x89504E470D0A1A0AuL.toLong(), buffer.getLong())
        val types = ArrayList<String>()
        while (buffer.hasRemaining()) {
            val data = ByteArray(buffer.getInt() + 4)
            buffer.get(data)
            val crc = CRC32().apply { update(data) }
            types.add(String(data, 0, 4, Charsets.US_ASCII))
            assertEquals(crc.value.toInt(), buffer.getInt(), types.last())
        }
        assertEquals(listOf("IHDR", "sRGB", "IDAT", "IEND"), types)
    }

    @Test
    fun aPictureInMemoryIsWrittenWithoutAlphaIfItIsOpaque() {
        val opaque = Image(1, 1, intArrayOf(-1), IntArray(1), IntArray(1), Counters.NONE)
        opaque.writePng(folder.resolve("opaque.png"))
        image.writePng(folder.resolve("clear.png"))
        assertEquals(3, ImageIO.read(folder.resolve("opaque.png").toFile()).colorModel.numComponents)
        assertEquals(4, ImageIO.read(folder.resolve("clear.png").toFile()).colorModel.numComponents)
    }

    @Test
    fun aPngGoesToAStreamWhichStaysOpen() {
        val output = object : ByteArrayOutputStream() {
            var isClosed = false
            var isFlushed = false

            override fun flush() {
                isFlushed = true
            }

            override fun close() {
                isClosed = true
            }
        }
        image.writePng(output)
        assertTrue(output.isFlushed && !output.isClosed)
        image.writePng(folder.resolve("a.png"))
        assertArrayEquals(Files.readAllBytes(folder.resolve("a.png")), output.toByteArray())
        assertArrayEquals(output.toByteArray(), image.toPng())
    }

    @Test
    fun ppmHasTheColoursAndDropsAlpha() {
        val path = folder.resolve("a.ppm")
        image.writePpm(path)
        val expected = "P6\n3 2\n255\n".toByteArray() +
            intArrayOf(1, 2, 3, 255, 0, 255, 0, 0, 0, 255, 255, 255, 128, 128, 128, 0x20, 0x30, 0x40).map {
                it.toByte()
            }
        assertEquals(expected.toList(), Files.readAllBytes(path).toList())
    }

    @Test
    fun pfmHasTheDepthsFromTheBottomRowUp() {
        val path = folder.resolve("a.pfm")
        image.writePfm(path)
        val bytes = Files.readAllBytes(path)
        val header = "Pf\n3 2\n-1.0\n"
        assertEquals(header, String(bytes, 0, header.length))
        val floats = ByteBuffer.wrap(bytes, header.length, 24).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer()
        val rows = List(6) { floats.get(it) }
        assertEquals(listOf(0.25f, 0.5f, Float.POSITIVE_INFINITY, 0f, 1f, Float.POSITIVE_INFINITY), rows)
        assertEquals(header.length + 24, bytes.size)
    }

    @Test
    fun rowsOutOfOrderAreRefused() {
        val row = IntArray(3)
        for (sink in listOf(PngSink(ByteArrayOutputStream(), 3, 3), PpmSink(ByteArrayOutputStream(), 3, 3))) {
            assertThrows(IllegalArgumentException::class.java) { sink.row(-1, row, row, row) }
            sink.row(5, row, row, row)
            assertThrows(IllegalArgumentException::class.java) { sink.row(5, row, row, row) }
            assertThrows(IllegalArgumentException::class.java) { sink.row(7, row, row, row) }
            sink.row(6, row, row, row)
            sink.row(7, row, row, row)
            assertThrows(IllegalArgumentException::class.java) { sink.row(8, row, row, row) }
        }
    }

    @Test
    fun anIncompletePictureIsAnErrorAtTheEnd() {
        val error = assertThrows(IOException::class.java) { PngSink(ByteArrayOutputStream(), 3, 2).close() }
        assertEquals("the image is incomplete: 0 of 2 rows", error.message)
        assertThrows(IOException::class.java) { PpmSink(ByteArrayOutputStream(), 3, 2).close() }
    }
}
