package dev.lazyz.scenes.images

import com.sun.management.ThreadMXBean
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.images.PngFile.bytes
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.material.Texture
import java.awt.color.ColorSpace
import java.awt.color.ICC_Profile
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class TextureFilesTest {
    private val source get() = TestSources.of("")

    private fun texels(bytes: ByteArray): List<String> {
        val texture = checkNotNull(TextureFiles.decode(source, bytes, "test")) { "not decoded" }
        return (0 until texture.height).flatMap { y -> (0 until texture.width).map { x -> hex(texture, x, y) } }
    }

    private fun hex(texture: Texture, x: Int, y: Int) = "%08X".format(texture.texel(x, y))

    @Test
    fun greyIsTheCodeThatTheFileStores() {
        val png = PngFile.of(3, 1, 8, PngFile.GREY, listOf(bytes(0, 128, 255)))
        assertEquals(listOf("FF000000", "FF808080", "FFFFFFFF"), texels(png))
        val withAlpha = PngFile.of(2, 1, 8, PngFile.GREY_ALPHA, listOf(bytes(128, 64, 200, 0)))
        assertEquals(listOf("40808080", "00C8C8C8"), texels(withAlpha))
    }

    @Test
    fun coloursAreTheCodesThatTheFileStores() {
        val png = PngFile.of(2, 2, 8, PngFile.RGB, listOf(bytes(1, 2, 3, 254, 128, 0), bytes(9, 8, 7, 0, 0, 255)))
        assertEquals(listOf("FF010203", "FFFE8000", "FF090807", "FF0000FF"), texels(png))
        val withAlpha = PngFile.of(2, 1, 8, PngFile.RGBA, listOf(bytes(1, 2, 3, 4, 200, 100, 50, 0)))
        assertEquals(listOf("04010203", "00C86432"), texels(withAlpha))
    }

    @Test
    fun paletteKeepsColourAndTransparency() {
        val palette = "PLTE" to bytes(10, 20, 30, 200, 100, 50)
        val png = PngFile.of(2, 1, 8, PngFile.PALETTE, listOf(bytes(1, 0)), palette, "tRNS" to bytes(0x80))
        assertEquals(listOf("FFC86432", "800A141E"), texels(png))
    }

    @Test
    fun oneTransparentColourIsTransparent() {
        val key = "tRNS" to bytes(0, 10, 0, 20, 0, 30)
        val png = PngFile.of(2, 1, 8, PngFile.RGB, listOf(bytes(10, 20, 30, 11, 20, 30)), key)
        assertEquals(listOf("00", "FF"), texels(png).map { it.take(2) })
    }

    @Test
    fun otherDepthsAreScaledToTheNearest() {
        val row = bytes(0x80, 0x80, 0, 127, 0, 128, 0, 129, 255, 255, 1, 0, 0, 0, 0, 0, 1, 2)
        val wide = PngFile.of(3, 1, 16, PngFile.RGB, listOf(row))
        assertEquals(listOf("FF800000", "FF01FF01", "FF000001"), texels(wide))
        val bits = PngFile.of(3, 1, 1, PngFile.GREY, listOf(bytes(0b10100000)))
        assertEquals(listOf("FFFFFFFF", "FF000000", "FFFFFFFF"), texels(bits))
        val fourBits = PngFile.of(2, 1, 4, PngFile.GREY, listOf(bytes(0x7F)))
        assertEquals(listOf("FF777777", "FFFFFFFF"), texels(fourBits))
    }

    @Test
    fun gammaOfAPngIsNotApplied() {
        val row = listOf(bytes(50, 100, 150))
        val gamma = "gAMA" to bytes(0, 1, 0x86, 0xA0)
        assertEquals(listOf("FF326496"), texels(PngFile.of(1, 1, 8, PngFile.RGB, row, gamma)))
    }

    @Test
    fun profileOfAJpegIsNotApplied() {
        // The same file twice, once said to be in linear light: a profile that is applied makes it much brighter
        val image = BufferedImage(16, 16, BufferedImage.TYPE_3BYTE_BGR)
        for (i in 0 until 256) image.raster.setPixel(i % 16, i / 16, intArrayOf(100, 60, 30))
        val plain = jpeg(image)
        val profile = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).data
        val mark = "ICC_PROFILE".toByteArray() + bytes(0, 1, 1)
        val length = 2 + mark.size + profile.size
        val afterJfif = 4 + (plain[5].toInt() and 0xFF)
        val said = plain.copyOf(afterJfif) + bytes(0xFF, 0xE2, length shr 8, length) + mark + profile +
            plain.copyOfRange(afterJfif, plain.size)
        assertEquals(texels(plain), texels(said))
        assertEquals(100.0, (texels(said)[0].substring(2, 4).toInt(16)).toDouble(), 4.0)
    }

    @Test
    fun greyJpegIsTheCodeThatTheFileStores() {
        val grey = BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY)
        for (i in 0 until 64) grey.raster.setSample(i % 8, i / 8, 0, 128)
        assertEquals("FF808080", texels(jpeg(grey))[0])
    }

    @Test
    fun rowsRunFromTheTop() {
        val image = BufferedImage(1, 2, BufferedImage.TYPE_INT_RGB)
        image.setRGB(0, 0, 0x112233)
        image.setRGB(0, 1, 0x445566)
        val out = ByteArrayOutputStream()
        ImageIO.write(image, "bmp", out)
        assertEquals(listOf("FF112233", "FF445566"), texels(out.toByteArray()))
    }

    @Test
    fun damageGivesNoTextureAndNoException() {
        val png = PngFile.of(5, 4, 8, PngFile.RGBA, List(4) { ByteArray(20) { 77 } })
        for (length in png.indices) TextureFiles.decode(source, png.copyOf(length), "test")
        for (at in png.indices) {
            TextureFiles.decode(source, png.copyOf().also { it[at] = (it[at].toInt() xor 0x55).toByte() }, "test")
        }
        assertNull(TextureFiles.decode(source, png.copyOf(50), "test"))
        assertNull(TextureFiles.decode(source, ByteArray(0), "test"))
        assertNull(TextureFiles.decode(source, "not a picture".toByteArray(), "test"))
    }

    @Test
    fun headerThatPromisesTooMuchIsNotBelieved() {
        // The longer file would have room for the picture, if it were one colour
        for ((side, padding) in listOf(60_000 to 0, 16_000 to 0, 20_000 to 40_000)) {
            val png = PngFile.of(side, side, 8, PngFile.RGBA, listOf(ByteArray(4)), "paDd" to ByteArray(padding))
            val before = allocated()
            try {
                assertNull(TextureFiles.decode(source, png, "test"), "$side")
            } catch (refused: SceneFormatException) {
                assertTrue("LoadLimits.decodedBytes" in refused.message.orEmpty(), "$side: $refused")
            }
            assertTrue(allocated() - before < 10_000_000, "$side took ${allocated() - before} bytes")
        }
    }

    @Test
    fun findWarnsOfWhatIsMissing(@TempDir folder: Path) {
        val stream = TestSources.of("")
        assertNull(TextureFiles.find(stream, "wood.png"))
        assertEquals(1, stream.warnings.size)

        Files.write(folder.resolve("bad.png"), ByteArray(100))
        Files.write(folder.resolve("good.png"), PngFile.of(1, 1, 8, PngFile.GREY, listOf(bytes(7))))
        val file = TestSources.of("", folder)
        assertNull(TextureFiles.find(file, "wood.png"))
        assertNull(TextureFiles.find(file, "bad.png"))
        assertTrue(file.warnings[0].contains("wood.png is missing"), file.warnings[0])
        assertTrue(file.warnings[1].contains("bad.png cannot be decoded"), file.warnings[1])
        assertNotNull(TextureFiles.find(file, ".\\Good.PNG"))
        assertEquals(2, file.warnings.size)
    }

    private fun allocated(): Long =
        (ManagementFactory.getThreadMXBean() as ThreadMXBean).getThreadAllocatedBytes(Thread.currentThread().id)

    private fun jpeg(image: BufferedImage): ByteArray {
        val out = ByteArrayOutputStream()
        check(ImageIO.write(image, "jpg", out))
        return out.toByteArray()
    }
}
