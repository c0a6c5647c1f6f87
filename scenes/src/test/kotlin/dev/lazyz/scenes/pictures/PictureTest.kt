package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.writers.PpmSink
import dev.lazyz.scenes.writers.toPng
import java.awt.Transparency
import java.awt.color.ColorSpace
import java.awt.image.BufferedImage
import java.awt.image.ComponentColorModel
import java.awt.image.DataBuffer
import java.io.ByteArrayOutputStream
import java.nio.file.Path
import javax.imageio.ImageIO
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Pictures are the numbers that a file stores, whatever the form of the file. */
class PictureTest {
    @TempDir
    lateinit var folder: Path

    private fun png(image: BufferedImage): Picture =
        Picture.decode(ByteArrayOutputStream().also { ImageIO.write(image, "png", it) }.toByteArray())

    private fun filled(type: Int, vararg samples: Int) = BufferedImage(3, 2, type).apply {
        for (y in 0 until height) for (x in 0 until width) raster.setPixel(x, y, samples)
    }

    private fun colors(picture: Picture): Set<String> =
        (0 until picture.height).flatMap { y -> (0 until picture.width).map { picture.color(it, y) } }.toSet()

    @Provide
    fun images(): Arbitrary<Image> = Arbitraries.integers().array(IntArray::class.java).ofSize(12)
        .map { Image(4, 3, it, IntArray(12), IntArray(12), Counters.NONE) }

    /** The colours of transparent pixels, too. */
    @Property(tries = 50, seed = "1")
    fun whatIsWrittenIsReadBack(@ForAll("images") image: Image) {
        val read = Picture.decode(image.toPng())
        assertTrue(PictureDifference.between(Picture.of(image), read).isIdentical)
    }

    @Test
    fun sixteenBitsAreNotRounded() {
        assertEquals(setOf("#808180818081ffff"), colors(png(filled(BufferedImage.TYPE_USHORT_GRAY, 0x8081))))
        assertEquals(setOf("#808080ff"), colors(png(filled(BufferedImage.TYPE_USHORT_GRAY, 0x8080))))
        val space = ColorSpace.getInstance(ColorSpace.CS_sRGB)
        val model = ComponentColorModel(space, true, false, Transparency.TRANSLUCENT, DataBuffer.TYPE_USHORT)
        val image = BufferedImage(model, model.createCompatibleWritableRaster(1, 1), false, null)
        image.raster.setPixel(0, 0, intArrayOf(0x0102, 0x0304, 0x0506, 0x0708))
        assertEquals("#0102030405060708", png(image).color(0, 0))
        assertEquals(0x0708_0102_0304_0506L, png(image).argb(0, 0))
    }

    @Test
    fun ppmFilesAreRead() {
        val argb = intArrayOf(0x102030, 0x0A2320, 0xFFFFFF, 0, 0x80FF00, 0x010203)
        val out = ByteArrayOutputStream()
        PpmSink(out, 3, 2).use { sink ->
            for (y in 0..1) sink.row(y, argb.copyOfRange(3 * y, 3 * y + 3), IntArray(3), IntArray(3))
        }
        val picture = Picture.decode(out.toByteArray())
        assertEquals(listOf(3, 2), listOf(picture.width, picture.height))
        for (i in argb.indices) assertEquals("#%06xff".format(argb[i]), picture.color(i % 3, i / 3))
        assertEquals("#61625aff", Picture.decode("P6 # one\n1\n# pixel\n1 255\nabZ".toByteArray()).color(0, 0))

        fun message(text: String) =
            assertThrows(SceneFormatException::class.java) { Picture.decode(text.toByteArray(), "a") }.message.orEmpty()
        assertTrue("a: it ends 2 bytes before its last pixel" in message("P6 1 1 255\na"))
        assertTrue("its height is not in 1.." in message("P6 1 99999999999999999999 255\na"))
        assertTrue("its maximum is 65535" in message("P6 1 1 65535\nabcdef"))
        assertTrue("its width is not in" in message("P6 "))
    }

    @Test
    fun badFilesAreReported() {
        fun message(read: () -> Picture) = assertThrows(SceneFormatException::class.java) { read() }.message
        val missing = folder.resolve("missing.png")
        assertEquals("$missing: there is no such file", message { Picture.read(missing) })
        assertEquals("$folder: it is a folder; name an image file", message { Picture.read(folder) })
        val words = "it is no image that can be decoded; save it as PNG"
        assertEquals("<bytes>: $words", message { Picture.decode("text".toByteArray()) })
        val whole = Image(2, 1, IntArray(2), IntArray(2), IntArray(2), Counters.NONE).toPng()
        assertEquals("a: $words", message { Picture.decode(whole.copyOf(whole.size / 2), "a") })
    }
}
