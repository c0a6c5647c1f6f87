package dev.lazyz.scenes.aov

import com.fasterxml.jackson.databind.ObjectMapper
import dev.lazyz.Region
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipInputStream
import javax.imageio.ImageIO
import kotlin.io.path.exists
import kotlin.io.path.inputStream
import kotlin.io.path.readBytes
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Files of AOVs, read back by code that has nothing in common with the writers. */
class AovFilesTest {
    @TempDir
    lateinit var folder: Path

    private val region = Region(5, 7, 8, 9)
    private val infinity = Float.POSITIVE_INFINITY
    private val depth = AovImage(Aov.DEPTH, region, floatArrayOf(2f, 2.5f, 4f, infinity, 3f, 3.75f), 2.0, 4.0)
    private val normal = AovImage(Aov.NORMAL, region, FloatArray(18) { (it - 9) / 9f }, -1.0, 1.0)
    private val uv = AovImage(Aov.UV, region, FloatArray(12) { it / 8f - 0.25f }, 0.0, 1.0)
    private val ids = AovImage(Aov.OBJECT, region, intArrayOf(-1, 0, 1, 300, 65534, 7))
    private val counts = AovImage(Aov.OVERDRAW, region, intArrayOf(0, 1, 2, 3, 65535, 5))

    private fun written(name: String, vararg images: AovImage): Path =
        folder.resolve(name).also { AovFiles.write(it, images.asList()) }

    /** The numbers of a PFM file in rows from the top, after its three lines. */
    private fun pfm(file: Path): Pair<List<String>, List<Float>> {
        val bytes = file.readBytes()
        var start = 0
        val lines = List(3) {
            val end = (start until bytes.size).first { i -> bytes[i] == '\n'.code.toByte() }
            String(bytes, start, end - start).also { start = end + 1 }
        }
        val numbers = ByteBuffer.wrap(bytes, start, bytes.size - start).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer()
        val all = List(numbers.remaining()) { numbers.get(it) }
        val (_, height) = lines[1].split(' ').map { it.toInt() }
        return lines to all.chunked(all.size / height).reversed().flatten()
    }

    /** The header and the 32-bit words of the bytes of an array of NumPy. */
    private fun npy(bytes: ByteArray): Pair<String, List<Int>> {
        assertArrayEquals(byteArrayOf(0x93.toByte(), 'N'.code.toByte()), bytes.copyOf(2))
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val length = buffer.getShort(8).toInt()
        val start = 10 + length
        assertEquals(0, start % 64)
        val words = List((bytes.size - start) / 4) { buffer.getInt(start + 4 * it) }
        return String(bytes, 10, length) to words
    }

    private fun bits(image: AovImage): List<Int> =
        if (image.aov.isInteger) image.ints.toList() else image.floats.map { it.toRawBits() }

    /** The samples of an image file in rows from the top. */
    private fun png(file: Path): List<Int> {
        val raster = ImageIO.read(file.toFile()).raster
        assertEquals(16, raster.sampleModel.getSampleSize(0))
        return raster.getPixels(0, 0, raster.width, raster.height, null as IntArray?).toList()
    }

    @Test
    fun floatMapsHaveOneChannelOrThree() {
        val (lines, numbers) = pfm(written("d.pfm", depth))
        assertEquals(listOf("Pf", "3 2", "-1.0"), lines)
        assertEquals(depth.floats.toList(), numbers)
        assertEquals(listOf("PF", "3 2", "-1.0") to normal.floats.toList(), pfm(written("n.PFM", normal)))
        val padded = uv.floats.toList().chunked(2).flatMap { it + 0f }
        assertEquals(padded, pfm(written("u.pfm", uv)).second)
        assertEquals(ids.ints.map { it.toFloat() }, pfm(written("i.pfm", ids)).second)
    }

    @Test
    fun arraysOfNumPyHaveTheBits() {
        for (image in listOf(depth, normal, uv, ids, counts)) {
            val (header, words) = npy(written("a.npy", image).readBytes())
            val type = if (image.aov.isInteger) "<i4" else "<f4"
            val shape = if (image.aov.channels.size == 1) "(2, 3)" else "(2, 3, ${image.aov.channels.size})"
            assertEquals("{'descr': '$type', 'fortran_order': False, 'shape': $shape, }", header.trim())
            assertTrue(header.endsWith("\n"))
            assertEquals(bits(image), words)
        }
    }

    @Test
    fun archivesHaveAnArrayForEach() {
        val file = written("all.npz", depth, normal, ids)
        val found = LinkedHashMap<String, List<Int>>()
        ZipInputStream(file.inputStream()).use { archive ->
            while (true) found[(archive.nextEntry ?: break).name] = npy(archive.readBytes()).second
        }
        val expected = listOf(depth, normal, ids).associate { "${it.aov.id}.npy" to bits(it) }
        assertEquals(expected, found)
        assertArrayEquals(file.readBytes(), written("again.npz", depth, normal, ids).readBytes())
        assertEquals(22, written("empty.npz").readBytes().size)
    }

    @Test
    fun namesOfObjectsAreATable() {
        val names = listOf("a\uD83D\uDE97", "\uD800", "end")
        val named = AovImage(Aov.OBJECT, region, intArrayOf(-1, 0, 1, 1, 1, -1), names = names)
        val archive = written("named.npz", named, depth)
        ZipInputStream(archive.inputStream()).use { entries ->
            val found = generateSequence { entries.nextEntry }.associate { it.name to npy(entries.readBytes()) }
            assertEquals(listOf("object.npy", "object-names.npy", "depth.npy"), found.keys.toList())
            val (header, words) = found.getValue("object-names.npy")
            assertEquals("{'descr': '<U3', 'fortran_order': False, 'shape': (3,), }", header.trim())
            assertEquals(listOf('a'.code, 0x1F697, 0, 0xFFFD, 0, 0, 'e'.code, 'n'.code, 'd'.code), words)
        }

        val table = written("named.json", named)
        val found = ObjectMapper().readTree(table.readBytes())["objects"].map { "$it" }
        val expected = listOf(
            "{'id':0,'name':'a\uD83D\uDE97','pixels':1,'columns':[6,7],'rows':[7,8]}",
            "{'id':1,'name':'\uFFFD','pixels':3,'columns':[5,8],'rows':[7,9]}",
        )
        assertEquals(expected.map { it.replace('\'', '"') }, found)
        assertEquals("[]", "${ObjectMapper().readTree(written("none.json", ids(-1)).readBytes())["objects"]}")
        val wrong = assertThrows(IllegalArgumentException::class.java) { written("depth.json", depth) }
        assertTrue("use .npz for 'depth'" in wrong.message.orEmpty()) { wrong.message }
    }

    private fun ids(id: Int) = AovImage(Aov.OBJECT, Region(0, 0, 1, 1), intArrayOf(id))

    @Test
    fun picturesOf16BitsAreScaledByFixedRanges() {
        assertEquals(listOf(0, 16384, 65534, 65535, 32767, 57342), png(written("d.png", depth)))
        val text = String(folder.resolve("d.png").readBytes(), Charsets.ISO_8859_1)
        for (part in listOf("tEXtaov\u0000depth", "tEXtnear\u00002.0", "tEXtfar\u00004.0")) {
            assertTrue(part in text) {
                part
            }
        }
        val components = normal.floats.map { Math.rint((it + 1.0) / 2 * 65535).toInt() }
        assertEquals(components, png(written("n.png", normal)))
        val places = uv.floats.toList().chunked(2).flatMap { it + 0f }.map {
            Math.rint(it.coerceIn(0f, 1f) * 65535.0).toInt()
        }
        assertEquals(places, png(written("u.png", uv)))
        assertEquals(ids.ints.map { it + 1 }, png(written("i.png", ids)))
        assertEquals(counts.ints.toList(), png(written("c.png", counts)))
    }

    @Test
    fun aWidePictureHasSeveralChunks() {
        val wide = Region(0, 0, 500, 400)
        val random = java.util.Random(1)
        val noise = AovImage(Aov.OVERDRAW, wide, IntArray(500 * 400) { random.nextInt(65536) })
        assertEquals(noise.ints.toList(), png(written("noise.png", noise)))
    }

    @Test
    fun whatDoesNotFitIsRefusedAndLeavesNoFile() {
        val many = AovImage(Aov.PRIMITIVE, Region(0, 0, 1, 1), intArrayOf(65535))
        val position = AovImage(Aov.POSITION, Region(0, 0, 1, 1), FloatArray(3), 0.0, 1.0)
        refused("many.png", "'primitive' reaches 65535", "use .npy", many)
        refused("position.png", "positions have no range", "use .npy", position)
        refused("two.npy", "one AOV, and these are 2", "use .npz", depth, normal)
        refused("none.pfm", "these are 0", "use .npz")
        refused("depth.exr", "cannot tell the format", ".pfm, .npy, .npz, .png", depth)
        assertNull(AovFormat.ofPath(Path.of("npy")))
        assertThrows(IOException::class.java) { written("missing/d.npy", depth) }
    }

    private fun refused(name: String, what: String, remedy: String, vararg images: AovImage) {
        val failure = assertThrows(IllegalArgumentException::class.java) { written(name, *images) }
        for (part in listOf(name, what, remedy)) assertTrue(part in failure.message!!) { failure.message }
        assertFalse(folder.resolve(name).exists())
        assertEquals(0, Files.list(folder).use { it.count() })
    }
}
