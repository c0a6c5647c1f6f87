package dev.lazyz.scenes.images

import com.sun.management.ThreadMXBean
import dev.lazyz.scenes.images.PngFile.bytes
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.material.Texture
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.lang.management.ManagementFactory
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream
import javax.imageio.IIOException
import javax.imageio.ImageIO
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Decoders see only what the pixels need: anything else may take any amount of memory. */
class NeededPartsTest {
    /** Texts and profiles of 100 MB, which are some 100 kB in the file. */
    @Test
    fun compressedTextsOfAPngTakeNoMemory() {
        val packed = packed(100_000_000)
        val text = "a".toByteArray()
        val chunks = mapOf(
            "zTXt" to text + bytes(0, 0) + packed,
            "iTXt" to text + bytes(0, 1, 0, 0, 0) + packed,
            "iCCP" to text + bytes(0, 0) + packed,
            "tEXt" to text + ByteArray(1_000_000),
            "eXIf" to ByteArray(1_000_000),
            "sPLT" to text + ByteArray(1_000_000),
        )
        val plain = PngFile.of(2, 1, 8, PngFile.RGB, listOf(bytes(1, 2, 3, 4, 5, 6)))
        for ((name, data) in chunks) {
            val png = PngFile.of(2, 1, 8, PngFile.RGB, listOf(bytes(1, 2, 3, 4, 5, 6)), name to data)
            assertArrayEquals(plain, NeededParts.of(png), name)
            assertEquals(0xFF040506.toInt(), decodedInLittleMemory(png, name).texel(1, 0))
        }
    }

    @Test
    fun segmentsOfAJpegAreLeftOut() {
        val plain = image("jpg")
        assertArrayEquals(plain, NeededParts.of(plain))
        for (code in listOf(0xE0, 0xE1, 0xE2, 0xED, 0xEE, 0xEF, 0xFE)) {
            val segment = bytes(0xFF, code, 0xFF, 0xFF) + ByteArray(0xFFFF - 2)
            val many = plain.copyOf(2) + (1..100).fold(ByteArray(0)) { all, _ -> all + segment } +
                plain.copyOfRange(2, plain.size)
            assertArrayEquals(plain, NeededParts.of(many), "%X".format(code))
        }
        assertArrayEquals(plain, NeededParts.of(plain + ByteArray(1000)))
    }

    @Test
    fun scansOfAJpegAreLimited() {
        val plain = image("jpg")
        val scan = (2 until plain.size).first { plain.code(it) == 0xFF && plain.code(it + 1) == 0xDA }
        val data = plain.copyOfRange(scan, plain.size - 2)
        val many = (1..99).fold(plain.copyOf(plain.size - 2)) { all, _ -> all + data }
        assertNotNull(NeededParts.of(many + bytes(0xFF, 0xD9)))
        assertNull(NeededParts.of(many + data + bytes(0xFF, 0xD9)))
    }

    @Test
    fun extensionsAndFurtherImagesOfAGifAreLeftOut() {
        val plain = image("gif")
        val needed = checkNotNull(NeededParts.of(plain))
        val block = bytes(255) + ByteArray(255)
        val blocks = (1..1000).fold(ByteArrayOutputStream()) { all, _ -> all.apply { write(block) } }.toByteArray()
        val colors = 13 + (3 shl (plain.code(10) and 7) + 1)
        for (code in listOf(0xFE, 0xFF, 0x01)) {
            val more = bytes(0x21, code) + blocks + bytes(0)
            val gif = plain.copyOf(colors) + more + plain.copyOfRange(colors, plain.size - 1) + more + bytes(0x3B)
            assertArrayEquals(needed, NeededParts.of(gif), "%X".format(code))
            assertEquals(texels(plain), texels(gif))
        }
        val twice = plain.copyOf(plain.size - 1) + plain.copyOfRange(colors, plain.size)
        assertArrayEquals(needed, NeededParts.of(twice))
    }

    @Test
    fun sizesInTheHeaderOfABmpAreNotBelieved() {
        val plain = image("bmp")
        val texels = texels(plain)
        for (size in listOf(1 shl 30, -1)) {
            assertEquals(texels, texels(changed(plain, 2 to size)), "file size")
            assertEquals(texels, texels(changed(plain, 34 to size)), "image size")
            assertNull(NeededParts.of(changed(plain, 10 to size)), "pixels")
            assertNull(NeededParts.of(changed(plain, 14 to size)), "header")
        }
        for (kind in 4..5) assertNull(NeededParts.of(changed(plain, 30 to kind)), "a file as pixels")
        for (kind in listOf("LINK", "MBED")) {
            val code = kind.fold(0) { all, letter -> all shl 8 or letter.code }
            val header = ByteArray(124)
            plain.copyInto(header, 0, 14, 54)
            val long = plain.copyOf(14) + header + plain.copyOfRange(54, plain.size)
            val profiled = changed(
                long, 2 to long.size, 10 to plain.size - 3 * 16 * 16 + 84, 14 to 124, 70 to code, 14 + 112 to 124,
                14 + 116 to (1 shl 30),
            )
            decodedInLittleMemory(profiled, kind)
            assertEquals(texels, texels(profiled), kind)
        }
    }

    /** Also the size of the picture, which the header of the file may say differently. */
    @Test
    fun otherChunksOfAWebPAreLeftOut() {
        val plain = checkNotNull(javaClass.getResource("lossy-alpha.webp")).readBytes()
        assertArrayEquals(plain, NeededParts.of(plain))
        val profile = "ICCP".toByteArray() + bytes(3, 0, 0, 0, 1, 2, 3, 0)
        val more = plain.copyOf(30) + profile + plain.copyOfRange(30, plain.size)
        val claimed = changed(more, 4 to more.size - 8, 20 to 0x3C, 24 to 0x00FFFFFF, 27 to 0x00FFFFFF)
        claimed[30] = 'I'.code.toByte()
        assertArrayEquals(plain, NeededParts.of(claimed))
    }

    @Test
    fun damagedFilesOfEachKindGiveNoException() {
        val png = PngFile.of(2, 1, 8, PngFile.RGB, listOf(bytes(1, 2, 3, 4, 5, 6)), "tEXt" to bytes(65, 0, 66))
        for (image in listOf(png) + listOf("jpg", "gif", "bmp", "tiff").map(::image)) {
            for (at in 0 until minOf(image.size, 300)) {
                NeededParts.of(image.copyOf(at))
                for (change in listOf(0xFF, 0x80, 0x01)) {
                    val broken = image.copyOf().also { it[at] = (it[at].toInt() xor change).toByte() }
                    NeededParts.of(broken)
                }
            }
        }
    }

    @Test
    fun memoryThatIsTooSmallIsNoDamage() {
        val png = PngFile.of(1, 1, 8, PngFile.GREY, listOf(bytes(1)))
        val full = OutOfMemoryError()
        for (failure in listOf<Exception>(IIOException("a", full), RuntimeException(full))) {
            assertThrows(OutOfMemoryError::class.java) {
                ImageDecoder.decode(png, admit = { _, _ -> }) { throw failure }
            }
        }
    }

    private fun packed(size: Int): ByteArray {
        val out = ByteArrayOutputStream()
        DeflaterOutputStream(out, Deflater(1)).use { stream -> repeat(size / 1000) { stream.write(ByteArray(1000)) } }
        return out.toByteArray()
    }

    private fun image(format: String): ByteArray {
        val image = BufferedImage(16, 16, BufferedImage.TYPE_3BYTE_BGR)
        for (i in 0 until 256) image.setRGB(i % 16, i / 16, if (i < 128) 0xFF0000 else 0x0000FF)
        val out = ByteArrayOutputStream()
        check(ImageIO.write(image, format, out))
        return out.toByteArray()
    }

    /** Returns [bytes] with 32-bit numbers at the given places. */
    private fun changed(bytes: ByteArray, vararg numbers: Pair<Int, Int>): ByteArray {
        val copy = bytes.copyOf()
        val buffer = ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN)
        for ((at, number) in numbers) buffer.putInt(at, number)
        return copy
    }

    private fun texels(bytes: ByteArray): List<Int> {
        val texture = checkNotNull(TextureFiles.decode(TestSources.of(""), bytes, "a"))
        return (0 until texture.width * texture.height).map { texture.texel(it % texture.width, it / texture.width) }
    }

    /** Decodes [bytes]. Fails if that takes more than some megabytes in addition to twice the file. */
    private fun decodedInLittleMemory(bytes: ByteArray, what: String): Texture {
        val before = allocated()
        val texture = checkNotNull(TextureFiles.decode(TestSources.of(""), bytes, "a")) { what }
        val taken = allocated() - before
        assertTrue(taken < 2 * bytes.size + 5_000_000, "$what took $taken bytes")
        return texture
    }

    private fun allocated(): Long =
        (ManagementFactory.getThreadMXBean() as ThreadMXBean).getThreadAllocatedBytes(Thread.currentThread().id)
}
