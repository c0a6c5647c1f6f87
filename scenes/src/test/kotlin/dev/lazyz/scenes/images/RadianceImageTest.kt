package dev.lazyz.scenes.images

import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.lighting.EnvironmentBackground
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.EnvironmentMap
import dev.lazyz.world.light.ToneMapping
import java.io.ByteArrayOutputStream
import java.nio.file.Path
import kotlin.io.path.writeBytes
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class RadianceImageTest {
    @TempDir
    lateinit var folder: Path

    private val header = "#?RADIANCE\n# made here\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n"

    /** The codes of a pixel: the left half is brighter, the lower half redder, and rows have runs. */
    private fun pixel(x: Int, y: Int, width: Int): ByteArray =
        byteArrayOf((100 + y).toByte(), (if (x < width / 2) 200 else 80).toByte(), (x / 5).toByte(), 128.toByte())

    private fun file(content: ByteArray): Path = folder.resolve("${content.contentHashCode()}.hdr").also {
        it.writeBytes(content)
    }

    private fun file(width: Int, height: Int, row: (ByteArrayOutputStream, List<ByteArray>) -> Unit): Path {
        val out = ByteArrayOutputStream()
        out.write("$header-Y $height +X $width\n".toByteArray())
        for (y in 0 until height) row(out, List(width) { pixel(it, y, width) })
        return file(out.toByteArray())
    }

    private fun flat(out: ByteArrayOutputStream, row: List<ByteArray>) = row.forEach { out.write(it) }

    private fun oldRuns(out: ByteArrayOutputStream, row: List<ByteArray>) {
        var x = 0
        while (x < row.size) {
            val run = row.drop(x).takeWhile { it.contentEquals(row[x]) }.size
            out.write(row[x])
            var rest = run - 1
            while (rest > 0) {
                out.write(byteArrayOf(1, 1, 1, (rest and 0xFF).toByte()))
                rest = rest ushr 8
            }
            x += run
        }
    }

    private fun newRuns(out: ByteArrayOutputStream, row: List<ByteArray>) {
        out.write(byteArrayOf(2, 2, (row.size shr 8).toByte(), row.size.toByte()))
        for (channel in 0 until 4) {
            var x = 0
            while (x < row.size) {
                val run = row.drop(x).take(127).takeWhile { it[channel] == row[x][channel] }.size
                if (run > 2) {
                    out.write(byteArrayOf((128 + run).toByte(), row[x][channel]))
                    x += run
                } else {
                    val count = minOf(row.size - x, 3)
                    out.write(byteArrayOf(count.toByte()) + ByteArray(count) { row[x + it][channel] })
                    x += count
                }
            }
        }
    }

    /** What is seen in front, at the right and above. */
    private fun seen(map: EnvironmentMap): List<Int> = listOf(
        Vector3d(0.0, 0.0, 1.0), Vector3d(1.0, 0.1, 0.0), Vector3d(0.1, 1.0, 0.1), Vector3d(0.0, -1.0, 0.1),
    ).map { target ->
        val camera = Camera.perspective(Vector3d(), target, Vector3d(0.0, 0.3, 1.0), 1.0, 0.1, 1.0)
        val scene = Scene(emptyList(), viewpoint = camera).withEnvironment(Environment.of(map))
            .withToneMapping(ToneMapping.NONE)
        var pixel = 0
        EnvironmentBackground(scene, 1, 1).behind(Region(0, 0, 1, 1), 1) { _, row, _, _ -> pixel = row[0] }
            .row(0, IntArray(1), IntArray(1), IntArray(1))
        pixel
    }

    @Test
    fun allEncodingsGiveTheSameLight() {
        val flat = seen(Scenes.environment(file(40, 20, ::flat)))
        assertEquals(flat, seen(Scenes.environment(file(40, 20, ::oldRuns))))
        assertEquals(flat, seen(Scenes.environment(file(40, 20, ::newRuns))))
        assertEquals(4, flat.toSet().size)
    }

    @Test
    fun theLightIsThatOfThePixels() {
        val out = ByteArrayOutputStream()
        out.write("$header-Y 4 +X 8\n".toByteArray())
        repeat(32) { out.write(byteArrayOf(128.toByte(), 64, 32, 128.toByte())) }
        val color = Rgba(0.5f, 0.25f, 0.125f).toArgb()
        assertEquals(List(4) { color }, seen(Scenes.environment(file(out.toByteArray()))))
    }

    @Test
    fun theSameContentIsComputedOnce() {
        val first = file(40, 20, ::newRuns)
        val second = folder.resolve("copy.hdr").also { it.writeBytes(first.toFile().readBytes()) }
        assertSame(Scenes.environment(first), Scenes.environment(second))
    }

    private fun message(content: ByteArray, limits: LoadLimits = LoadLimits()): String =
        assertThrows(SceneFormatException::class.java) { Scenes.environment(file(content), limits) }.message.orEmpty()

    @Test
    fun wrongFilesAreRefusedWithPlaceAndRemedy() {
        val whole = file(40, 20, ::newRuns).toFile().readBytes()
        for ((words, content) in listOf(
            "is empty" to byteArrayOf(),
            "byte 0: is no Radiance picture" to "P6\n1 1\n".toByteArray(),
            "byte 0: is an OpenEXR picture; save it as Radiance (.hdr)" to byteArrayOf(0x76, 0x2F, 0x31, 1, 2, 0, 0, 0),
            "byte 11: has 'FORMAT=32-bit_rle_xyze'" to "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n".toByteArray(),
            "has no size such as -Y 512 +X 1024" to "$header+X 4 -Y 4\n".toByteArray(),
            "has a side of 70000" to "$header-Y 4 +X 70000\n".toByteArray(),
            "has a side of 0" to "$header-Y 0 +X 4\n".toByteArray(),
            "has a line of more than 2048 bytes" to ("#?" + "x".repeat(3000)).toByteArray(),
            "byte 9: ends too early" to "#?RADIANC".toByteArray(),
            "byte ${whole.size - 5}: ends too early" to whole.copyOf(whole.size - 5),
            "is damaged" to "$header-Y 1 +X 8\n".toByteArray() + byteArrayOf(2, 2, 0, 8, 0),
            "is damaged" to "$header-Y 1 +X 8\n".toByteArray() + byteArrayOf(2, 2, 0, 8, -1),
            "is damaged" to "$header-Y 1 +X 4\n".toByteArray() + byteArrayOf(1, 1, 1, 2),
            "is damaged" to "$header-Y 1 +X 9\n".toByteArray() + byteArrayOf(2, 2, 0, 8),
        )) {
            val message = message(content)
            assertTrue(words in message) { "$words: $message" }
        }
    }

    @Test
    fun limitsHoldBeforeMemoryIsTaken() {
        val large = "$header-Y 60000 +X 60000\n".toByteArray()
        assertTrue("pixels of textures" in message(large, LoadLimits(texels = 1000)))
        assertTrue("decoded data" in message(large, LoadLimits(decodedBytes = 1 shl 20)))
    }

    /** Each cut and each changed byte gives light or a message. */
    @Test
    fun damagedFilesAreReadOrRefused() {
        val whole = file(16, 4, ::newRuns).toFile().readBytes()
        for (at in header.length until whole.size step 17) {
            for (content in listOf(whole.copyOf(at), whole.copyOf().also { it[at] = (it[at] + 101).toByte() })) {
                try {
                    Scenes.environment(file(content))
                } catch (refused: SceneFormatException) {
                    assertTrue("byte" in refused.message.orEmpty() || "decoded" in refused.message.orEmpty()) {
                        "$refused"
                    }
                }
            }
        }
    }

    @Test
    fun theBrightestPixelsAreLimited() {
        val out = ByteArrayOutputStream()
        out.write("$header-Y 2 +X 4\n".toByteArray())
        repeat(8) { out.write(byteArrayOf(-1, -1, -1, -1)) }
        assertArrayEquals(IntArray(4) { -1 }, seen(Scenes.environment(file(out.toByteArray()))).toIntArray())
    }

    /** Also where many pixels become one. */
    @Test
    fun theBrightestPixelsOfLargePicturesAreLimited() {
        val out = ByteArrayOutputStream()
        out.write("$header-Y 3 +X 6144\n".toByteArray())
        repeat(3 * 6144) { out.write(byteArrayOf(-1, -2, -3, -1)) }
        val map = Scenes.environment(file(out.toByteArray()))
        assertEquals(listOf(2048, 1), listOf(map.width, map.height))
        assertArrayEquals(IntArray(4) { -1 }, seen(map).toIntArray())
    }

    @Test
    fun pixelsOfLargePicturesStayWhereTheyAre() {
        fun halves(width: Int, height: Int): List<Int> {
            val out = ByteArrayOutputStream()
            out.write("$header-Y $height +X $width\n".toByteArray())
            for (i in 0 until width * height) {
                val isLeft = i % width < width / 2
                val isUpper = i / width < height / 2
                out.write(byteArrayOf(if (isLeft) 100 else 50, if (isUpper) 80 else 20, 60, 128.toByte()))
            }
            return seen(Scenes.environment(file(out.toByteArray())))
        }
        assertEquals(halves(2048, 2), halves(4096, 4))
    }

    @Test
    fun interruptsEndIt() {
        val picture = file(40, 20, ::flat)
        Thread.currentThread().interrupt()
        val failure = assertThrows(SceneFormatException::class.java) { Scenes.environment(picture) }
        assertTrue(Thread.interrupted())
        assertTrue("interrupted" in failure.message.orEmpty()) { "$failure" }
    }
}
