package dev.lazyz.scenes.images

import com.sun.management.ThreadMXBean
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.images.PngFile.bytes
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.material.Texture
import java.awt.Transparency
import java.awt.color.ColorSpace
import java.awt.color.ICC_ColorSpace
import java.awt.color.ICC_Profile
import java.awt.image.BufferedImage
import java.awt.image.ComponentColorModel
import java.awt.image.DataBuffer
import java.awt.image.Raster
import java.io.ByteArrayOutputStream
import java.lang.management.ManagementFactory
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageWriteParam
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
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
    fun profilesAndOrientationsAreIgnored() {
        val linear = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB)
        val model = ComponentColorModel(ICC_ColorSpace(linear), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE)
        val raster = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 2, 1, 3, null)
        raster.setPixels(0, 0, 2, 1, intArrayOf(10, 200, 30, 40, 50, 60))
        val tiff = ByteArrayOutputStream()
        assertTrue(ImageIO.write(BufferedImage(model, raster, false, null), "tiff", tiff))
        assertTrue(String(tiff.toByteArray(), Charsets.ISO_8859_1).contains("acsp"), "the profile is in the file")
        assertEquals(listOf("FF0AC81E", "FF28323C"), texels(tiff.toByteArray()))

        // Turned by a quarter: the tag 0x112 of TIFF has the number 6
        val turned = "II*".toByteArray() + bytes(0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0)
        val exif = "Exif".toByteArray() + bytes(0, 0) + turned
        val profile = "ICC_PROFILE".toByteArray() + bytes(0, 1, 1) + linear.data
        val plain = jpeg(BufferedImage(24, 8, BufferedImage.TYPE_3BYTE_BGR), ImageWriteParam.MODE_DISABLED)
        val segments = listOf(0xE1 to exif, 0xE2 to profile).fold(ByteArray(0)) { all, (code, data) ->
            all + bytes(0xFF, code, (data.size + 2) shr 8, data.size + 2) + data
        }
        val odd = plain.copyOf(2) + segments + plain.copyOfRange(2, plain.size)
        assertEquals(24, checkNotNull(TextureFiles.decode(source, odd, "test")).width)
        assertEquals(texels(plain), texels(odd))
        val rows = listOf(bytes(10, 200, 30, 40, 50, 60))
        val png = PngFile.of(2, 1, 8, PngFile.RGB, rows, "gAMA" to bytes(0, 1, 0x86, 0xA0), "eXIf" to turned)
        assertEquals(listOf("FF0AC81E", "FF28323C"), texels(png))
    }

    @Test
    fun wideColoursWithAlphaAreRounded() {
        val grey = PngFile.of(1, 1, 16, PngFile.GREY_ALPHA, listOf(bytes(0x80, 0x80, 0x40, 0xFF)))
        assertEquals(listOf("41808080"), texels(grey))
        val color = PngFile.of(1, 1, 16, PngFile.RGBA, listOf(bytes(1, 0, 2, 0xFF, 0xFF, 0xFF, 0, 0)))
        assertEquals(listOf("000103FF"), texels(color))
        val key = "tRNS" to bytes(1, 2, 3, 4, 5, 6)
        val clear = PngFile.of(2, 1, 16, PngFile.RGB, listOf(bytes(1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 7)), key)
        assertEquals(listOf("00", "FF"), texels(clear).map { it.take(2) })
    }

    /** A JPEG of one colour of [numbers], with Adobe's marker that says how they are transformed, or without one. */
    private fun jpegOf(numbers: List<Int>, transform: Int?): ByteArray {
        val raster = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 8, 8, numbers.size, null)
        for (i in 0 until 64) raster.setPixel(i % 8, i / 8, numbers.toIntArray())
        val out = ByteArrayOutputStream()
        val writer = ImageIO.getImageWritersByFormatName("jpeg").next()
        ImageIO.createImageOutputStream(out).use { stream ->
            writer.output = stream
            writer.write(null, IIOImage(raster, null, null), null)
        }
        writer.dispose()
        val plain = out.toByteArray()
        if (transform == null) return plain
        val marker = bytes(0xFF, 0xEE, 0, 14) + "Adobe".toByteArray() + bytes(0, 100, 0, 0, 0, 0, transform)
        return plain.copyOf(2) + marker + plain.copyOfRange(2, plain.size)
    }

    @Test
    fun jpegsCanHaveRedGreenAndBlue() {
        assertEquals("FFC81E5A", texels(jpegOf(listOf(200, 30, 90), 0))[0])
        assertEquals("FFC8C8C8", texels(jpegOf(listOf(200, 128, 128), 1))[0])
    }

    @Test
    fun inksBecomeTheColourThatTheyLeave() {
        val red = listOf(0, 255, 255, 0) to 0xFF0000
        val dark = listOf(200, 30, 90, 40) to 0x2EBE8B
        for ((inks, expected) in listOf(red, dark, listOf(0, 0, 0, 255) to 0, listOf(0, 0, 0, 0) to 0xFFFFFF)) {
            // Files have the inks inverted, or as luma and chroma of a colour that has their numbers
            val inverted = inks.map { 255 - it }
            val (c, m, y, k) = inks
            val luma = 0.299 * c + 0.587 * m + 0.114 * y
            val ycck = listOf(luma, 128 + (y - luma) * 0.564, 128 + (c - luma) * 0.713).map { Math.round(it).toInt() }
            val files = listOf(
                jpegOf(inverted, 0),
                jpegOf(inverted, null),
                jpegOf(ycck.map { minOf(it, 255) } + (255 - k), 2),
            )
            for ((form, file) in files.withIndex()) {
                val color = texels(file)[0].toLong(16).toInt()
                assertEquals(0xFF, color ushr 24, "$form")
                for (shift in listOf(16, 8, 0)) {
                    val difference = (color shr shift and 0xFF) - (expected shr shift and 0xFF)
                    assertTrue(Math.abs(difference) <= 4, "$inks in form $form: %08X".format(color))
                }
            }
        }
    }

    /** A TGA of [width] pixels in each row. */
    private fun tga(
        type: Int,
        depth: Int,
        width: Int,
        height: Int,
        data: ByteArray,
        descriptor: Int = 0,
        map: Boolean = false,
    ) =
        bytes(2, if (map) 1 else 0, type, if (map) 5 else 0, 0, if (map) 2 else 0, 0, if (map) 24 else 0, 0, 0, 0, 0) +
            bytes(width, width shr 8, height, height shr 8, depth, descriptor) + "id".toByteArray() +
            (if (map) bytes(30, 20, 10, 50, 100, 200) else ByteArray(0)) + data

    @Test
    fun tgaHasRowsFromTheBottomUnlessItSaysOtherwise() {
        val data = bytes(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)
        val rows = listOf("FF030201", "FF060504", "FF090807", "FF0C0B0A")
        assertEquals(rows, texels(tga(2, 24, 2, 2, data, 0x20)))
        assertEquals(rows.drop(2) + rows.take(2), texels(tga(2, 24, 2, 2, data)))
        assertEquals(listOf(1, 0, 3, 2).map(rows::get), texels(tga(2, 24, 2, 2, data, 0x30)))
    }

    @Test
    fun tgaIsReadInAllItsForms() {
        val withAlpha = bytes(1, 2, 3, 4, 5, 6, 7, 0)
        assertEquals(listOf("04030201", "00070605"), texels(tga(2, 32, 2, 1, withAlpha, 8)))
        assertEquals(listOf("FF030201", "FF070605"), texels(tga(2, 32, 2, 1, withAlpha)))
        assertEquals(listOf("FF030201"), texels(tga(2, 32, 1, 1, bytes(1, 2, 3, 0), 8)), "alpha of 0 everywhere")
        assertEquals(listOf("FF848421", "FFFF0000"), texels(tga(2, 16, 2, 1, bytes(0x04, 0x42, 0x00, 0x7C))))
        assertEquals(listOf("FF090909", "FFFFFFFF"), texels(tga(3, 8, 2, 1, bytes(9, 255))))
        assertEquals(listOf("80090909"), texels(tga(3, 16, 1, 1, bytes(9, 128), 8)))
        assertEquals(listOf("FFC86432", "FF0A141E"), texels(tga(1, 8, 2, 1, bytes(6, 5), map = true)))

        // Packets may go on in the next row; the last one may be too long
        val packed = tga(10, 24, 2, 2, bytes(0x82, 1, 2, 3, 1, 4, 5, 6, 7, 8, 9), 0x20)
        assertEquals(List(3) { "FF030201" } + "FF060504", texels(packed))
        assertEquals(listOf("FFC86432", "FFC86432"), texels(tga(9, 8, 2, 1, bytes(0x81, 6), map = true)))
        assertEquals(listOf("FF070707", "FF080808"), texels(tga(11, 8, 2, 1, bytes(1, 7, 8))))
    }

    @Test
    fun damagedTgaGivesNoTextureAndNoException() {
        val packed = tga(10, 32, 3, 2, bytes(0x82, 1, 2, 3, 4, 0, 5, 6, 7, 8, 0x81, 9, 9, 9, 9), 0x28)
        val mapped = tga(1, 8, 4, 1, bytes(5, 6, 5, 6), map = true)
        for (file in listOf(packed, mapped)) {
            for (length in file.indices) assertNull(TextureFiles.decode(source, file.copyOf(length), "test"), "$length")
            for (at in file.indices) {
                for (change in listOf(0xFF, 1, 0x80)) {
                    val damaged = file.copyOf().also { it[at] = (it[at].toInt() xor change).toByte() }
                    TextureFiles.decode(source, damaged, "test")
                }
            }
        }
        assertNull(TextureFiles.decode(source, tga(1, 8, 1, 1, bytes(4), map = true), "test"), "no such colour")
        val before = allocated()
        for (type in listOf(2, 10)) {
            assertNull(TextureFiles.decode(source, tga(type, 24, 65535, 65535, ByteArray(9000)), "test"))
        }
        assertTrue(allocated() - before < 10_000_000)
        val small = Source(ByteArray(0), "test", null, Loading(LoadOptions(LoadLimits(texels = 5))))
        val error = assertThrows(SceneFormatException::class.java) { TextureFiles.decode(small, packed, "test") }
        assertTrue("LoadLimits.texels" in error.message.orEmpty(), error.message)
    }

    private fun webP(name: String) = checkNotNull(javaClass.getResource("$name.webp")).readBytes()

    private fun assertNear(expected: List<Int>, texel: String) {
        val code = texel.toLong(16).toInt()
        val codes = listOf(code ushr 24, code shr 16 and 0xFF, code shr 8 and 0xFF, code and 0xFF)
        assertTrue(codes.zip(expected).all { (a, b) -> Math.abs(a - b) <= 6 }, "$codes, expected $expected")
    }

    /** The pixels of the files are formulas of x and y. */
    @Test
    fun webPIsReadWithAndWithoutLoss() {
        for ((at, texel) in texels(webP("lossless")).withIndex()) {
            val (x, y) = at % 5 to at / 5
            val alpha = if (x < 4) 255 else 40 + y * 60
            assertEquals("%02X%02X%02X%02X".format(alpha, x * 60, y * 100, x * y * 37 % 256), texel)
        }
        assertNear(listOf(255, 122, 123, 131), texels(webP("lossy"))[8 * 24 + 12])
        val withAlpha = texels(webP("lossy-alpha"))
        for (x in listOf(0, 12, 23)) assertEquals("%02X".format(x * 11), withAlpha[8 * 24 + x].take(2))
        assertNear(listOf(132, 121, 122, 130), withAlpha[8 * 24 + 12])
        assertEquals("FFFF0000", texels(webP("animated"))[0], "the first picture of an animation")
    }

    @Test
    fun damagedWebPGivesNoTextureAndNoException() {
        for (file in listOf("lossless", "lossy", "lossy-alpha", "animated").map(::webP)) {
            for (length in 0 until file.size - 1) TextureFiles.decode(source, file.copyOf(length), "test")
            for (at in file.indices) {
                for (change in listOf(0xFF, 1, 0x80)) {
                    val damaged = file.copyOf().also { it[at] = (it[at].toInt() xor change).toByte() }
                    val before = allocated()
                    TextureFiles.decode(source, damaged, "test")
                    assertTrue(allocated() - before < 50_000_000, "byte $at took ${allocated() - before} bytes")
                }
            }
        }
        val small = Source(ByteArray(0), "test", null, Loading(LoadOptions(LoadLimits(texels = 14))))
        val error = assertThrows(SceneFormatException::class.java) {
            TextureFiles.decode(small, webP("lossless"), "test")
        }
        assertTrue("LoadLimits.texels" in error.message.orEmpty(), error.message)
    }

    /** A picture of one block of pixels that names the last of 65,536 groups of codes, which all follow. */
    @Test
    fun tablesOfWebPThatFillMemoryAreDamage() {
        val bits = StringBuilder()
        fun add(value: Int, count: Int) = repeat(count) { bits.append(value shr it and 1) }
        add(0x2F, 8)
        add(3, 14) // width and height, less 1
        add(3, 14)
        add(0, 4 + 1 + 1) // no alpha, version 0, nothing transformed, no cache of colours
        add(1, 1) // several groups of codes
        add(0, 3 + 1) // for blocks of 4 x 4 pixels; no cache
        for (symbol in listOf(255, 255, 0, 0, 0)) {
            add(0b101, 3) // one symbol of 8 bits
            add(symbol, 8)
        }
        repeat(5 * 65_536) { add(1, 4) } // one symbol of one bit
        val content = bits.chunked(8).map { it.reversed().toInt(2).toByte() }.toByteArray()
        val file = ByteBuffer.allocate(20 + content.size).order(ByteOrder.LITTLE_ENDIAN)
            .put("RIFF".toByteArray()).putInt(12 + content.size).put("WEBPVP8L".toByteArray()).putInt(content.size)
            .put(content).array()
        val before = allocated()
        assertNull(TextureFiles.decode(source, file, "test"))
        val taken = allocated() - before
        assertTrue(taken in 60_000_000..80_000_000, "$taken bytes")
    }

    @Test
    fun webPIsLeftWhenTheLoadingEnds() {
        for (name in listOf("lossless", "lossy-alpha")) {
            val ended = SceneFormatException("test", null, "ended", "again")
            val caught = assertThrows(SceneFormatException::class.java) {
                ImageDecoder.decode(webP(name), admit = { _, _ -> }, look = { throw ended }) { it }
            }
            assertEquals(ended, caught)
        }
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

    private fun jpeg(image: BufferedImage, progressive: Int): ByteArray {
        val out = ByteArrayOutputStream()
        val writer = ImageIO.getImageWritersByFormatName("jpeg").next()
        val options = writer.defaultWriteParam.apply { progressiveMode = progressive }
        ImageIO.createImageOutputStream(out).use { stream ->
            writer.output = stream
            writer.write(null, IIOImage(image, null, null), options)
        }
        writer.dispose()
        return out.toByteArray()
    }

    @Test
    fun progressiveJpegsAreReadLikeOthers() {
        val image = BufferedImage(24, 16, BufferedImage.TYPE_3BYTE_BGR)
        for (i in 0 until 24 * 16) image.setRGB(i % 24, i / 24, i * 0x0A1F05)
        val (plain, progressive) =
            listOf(ImageWriteParam.MODE_DISABLED, ImageWriteParam.MODE_DEFAULT).map { jpeg(image, it) }
        assertTrue(progressive.indices.any { progressive.code(it) == 0xFF && progressive.code(it + 1) == 0xC2 })
        assertEquals(texels(plain), texels(progressive))
    }
}
