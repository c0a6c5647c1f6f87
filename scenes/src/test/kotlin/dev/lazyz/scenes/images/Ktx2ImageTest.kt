package dev.lazyz.scenes.images

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.images.PngFile.bytes
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.DeflaterOutputStream
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class Ktx2ImageTest {
    private val texels = bytes(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)

    /** A file with one level, the [texels] of which are compressed by [scheme], zlib if it is 3. */
    private fun ktx2(
        format: Int,
        width: Int,
        height: Int,
        texels: ByteArray,
        scheme: Int = 0,
        metadata: Map<String, String> = emptyMap(),
        colorModel: Int = 1,
    ): ByteArray {
        val data = if (scheme != 3) {
            texels
        } else {
            ByteArrayOutputStream().also { out ->
                DeflaterOutputStream(out).use { it.write(texels) }
            }.toByteArray()
        }
        val values = ByteArrayOutputStream()
        for ((key, value) in metadata) {
            val entry = "$key\u0000$value\u0000".toByteArray()
            values.write(bytes(entry.size, 0, 0, 0) + entry + ByteArray((4 - entry.size % 4) % 4))
        }
        val descriptor = 104
        val start = descriptor + 16 + values.size()
        val out = ByteBuffer.allocate(start + data.size).order(ByteOrder.LITTLE_ENDIAN)
        out.put(bytes(0xAB, 'K'.code, 'T'.code, 'X'.code, 0x20, '2'.code, '0'.code, 0xBB, 0x0D, 0x0A, 0x1A, 0x0A))
        for (number in listOf(format, 1, width, height, 0, 0, 1, 1, scheme)) out.putInt(number)
        for (number in listOf(descriptor, 16, descriptor + 16, values.size())) out.putInt(number)
        for (number in listOf(0L, 0L, start.toLong(), data.size.toLong(), texels.size.toLong())) out.putLong(number)
        out.put(ByteArray(12)).put(colorModel.toByte()).put(ByteArray(3)).put(values.toByteArray()).put(data)
        return out.array()
    }

    private fun decoded(bytes: ByteArray): List<String> {
        val texture = checkNotNull(TextureFiles.decode(TestSources.of(""), bytes, "test")) { "not decoded" }
        return List(texture.width * texture.height) {
            "%08X".format(texture.texel(it % texture.width, it / texture.width))
        }
    }

    @Test
    fun channelsAreThoseOfTheFormat() {
        assertEquals(listOf("FF010000", "FF020000"), decoded(ktx2(9, 2, 1, texels)))
        assertEquals(listOf("FF010200", "FF030400"), decoded(ktx2(22, 2, 1, texels)))
        assertEquals(listOf("FF010203", "FF040506"), decoded(ktx2(29, 2, 1, texels)))
        assertEquals(listOf("FF030201", "FF060504"), decoded(ktx2(30, 2, 1, texels)))
        assertEquals(listOf("04010203", "08050607"), decoded(ktx2(37, 1, 2, texels)))
        assertEquals(listOf("04030201", "08070605"), decoded(ktx2(50, 1, 2, texels)))
    }

    @Test
    fun metadataTurnsAndSwapsChannels() {
        val more = mapOf("KTXwriter" to "test", "KTXswizzle" to "rrr1", "KTXorientation" to "lu")
        assertEquals(listOf("FF040404", "FF030303", "FF020202", "FF010101"), decoded(ktx2(9, 2, 2, texels, 0, more)))
        assertEquals(listOf("02010100"), decoded(ktx2(16, 1, 1, texels, 0, mapOf("KTXswizzle" to "rr0g"))))
    }

    @Test
    fun zlibIsInflated() {
        assertEquals(decoded(ktx2(23, 2, 2, texels)), decoded(ktx2(23, 2, 2, texels, 3)))
        assertNull(TextureFiles.decode(TestSources.of(""), ktx2(23, 2, 3, texels, 3), "test"), "too few texels")
    }

    @Test
    fun zstandardIsDecoded() {
        val packed = checkNotNull(javaClass.getResource("zero.zst")).readBytes()
        assertEquals(List(200_000) { "FF000000" }, decoded(ktx2(9, 400, 500, packed, 2)))
        assertNull(Ktx2Image.of(ktx2(37, 100_000, 100_000, packed, 2)), "more than 32 KiB from a byte")
    }

    @Test
    fun otherFormatsAreNamedWithTheRemedy() {
        for ((file, text) in listOf(
            ktx2(0, 4, 4, texels, 1, colorModel = 163) to "(ETC1S); \"ktx extract --transcode rgba8",
            ktx2(0, 4, 4, texels, 2, colorModel = 166) to "(UASTC); \"ktx extract --transcode rgba8",
            ktx2(145, 4, 4, texels) to "the Vulkan format 145; save it as PNG",
            ktx2(37, 4, 0, texels) to "several pictures; save one as PNG",
            bytes(0, 0, 0, 0x20) + "ftypavif".toByteArray() to ": it is AVIF; save it as PNG, JPEG or WebP",
        )) {
            assertNull(TextureFiles.decode(TestSources.of(""), file, "test"))
            val warning = TextureFiles.notDecoded(file)
            assertTrue(text in warning, warning)
        }
    }

    @Test
    fun sizesAreNotBelieved() {
        for (scheme in listOf(0, 3)) {
            assertNull(Ktx2Image.of(ktx2(37, 100_000, 100_000, texels, scheme)))
            assertNull(Ktx2Image.of(ktx2(37, -1, -1, texels, scheme)))
        }
        val source = Source(ByteArray(0), "test", null, Loading(LoadOptions(LoadLimits(texels = 3))))
        assertThrows(SceneFormatException::class.java) { TextureFiles.decode(source, ktx2(23, 2, 2, texels), "test") }
    }

    @Test
    fun damageGivesNoException() {
        val file = ktx2(23, 2, 2, texels, 3, mapOf("KTXorientation" to "ru"))
        for (at in file.indices) {
            TextureFiles.decode(TestSources.of(""), file.copyOf(at), "test")
            for (change in listOf(0xFF, 0x80, 0x01)) {
                val broken = file.copyOf().also { it[at] = (it[at].toInt() xor change).toByte() }
                if (TextureFiles.decode(TestSources.of(""), broken, "test") == null) TextureFiles.notDecoded(broken)
            }
        }
    }
}
