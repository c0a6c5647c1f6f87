package dev.lazyz.scenes.streaming

import dev.lazyz.Renderer
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.surface.StreamedMesh
import java.io.UncheckedIOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.outputStream
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Files that are read part by part show the same as files that are read whole. */
class StreamedSceneTest {
    @TempDir
    lateinit var folder: Path

    private val spool: Path by lazy { folder.resolve("spool").also { it.toFile().mkdir() } }
    private val file get() = folder.resolve("model.stl")

    /** Three corners, and the word of a binary facet. */
    private class Facet(val corners: FloatArray, val word: Int = 0)

    /** A hilly square of [side] x [side] pairs of triangles, with a few strange ones among them. */
    private fun terrain(side: Int, word: (Int) -> Int = { 0 }): List<Facet> {
        fun point(x: Int, y: Int) = listOf(
            x.toFloat() / side, y.toFloat() / side,
            (StrictMath.sin(9.0 * x / side) * StrictMath.cos(7.0 * y / side) / 5).toFloat(),
        )
        val facets = ArrayList<Facet>()
        fun add(vararg points: List<Float>) {
            facets += Facet(points.asList().flatten().toFloatArray(), word(facets.size))
        }
        for (y in 0 until side) {
            for (x in 0 until side) {
                add(point(x, y), point(x + 1, y), point(x + 1, y + 1))
                add(point(x, y), point(x + 1, y + 1), point(x, y + 1))
                if (x == y) {
                    add(listOf(-0f, 0f, -0f), listOf(Float.NaN, 1f, 2f), listOf(3f, 4f, Float.POSITIVE_INFINITY))
                }
                if (x == y) add(point(x, y), point(side - x, y), point(x, y))
            }
        }
        return facets
    }

    private fun binary(facets: List<Facet>, header: String = ""): ByteArray {
        val buffer = ByteBuffer.allocate(84 + 50 * facets.size).order(ByteOrder.LITTLE_ENDIAN)
        buffer.put(header.toByteArray(Charsets.ISO_8859_1)).position(80).putInt(facets.size)
        for (facet in facets) {
            repeat(3) { buffer.putFloat(0f) }
            facet.corners.forEach { buffer.putFloat(it) }
            buffer.putShort(facet.word.toShort())
        }
        return buffer.array()
    }

    private fun ascii(facets: List<Facet>, offset: Double = 0.0): String = buildString {
        for ((number, part) in facets.chunked(1000).withIndex()) {
            append("solid part $number\r\n")
            for (facet in part) {
                append("facet normal 0 0 1 outer loop\n")
                for (corner in 0 until 3) {
                    val (x, y, z) = facet.corners.slice(3 * corner until 3 * corner + 3)
                    append("  vertex ${x + offset} ${y + offset} $z\n")
                }
                append("endloop\rendfacet\n")
            }
            append("endsolid part $number\n")
        }
    }

    private fun stream(limits: LoadLimits = LoadLimits()): StreamedScene =
        Scenes.stream(file, limits = limits, spool = spool)

    private fun hashes(loaded: LoadedScene, renderers: List<Renderer>): List<String> =
        renderers.map { it.render(loaded.scene.frame(90, 70)).pixelHash() }

    private fun assertSame(renderers: List<Renderer> = listOf(TiledRenderer())) {
        val whole = Scenes.load(file, LoadOptions(smoothNormals = false))
        stream().use { streamed ->
            assertEquals(whole.scene.bounds.toString(), streamed.loaded.scene.bounds.toString())
            assertEquals(hashes(whole, renderers), hashes(streamed.loaded, renderers))
            assertEquals(whole.warnings, streamed.loaded.warnings)
        }
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    private val all: List<Renderer> = listOf(TiledRenderer(), ZBufferRenderer(), HybridRenderer())

    @Test
    fun aCountOfZeroAndBytesBehindFacetsAreReadAlike() {
        val facets = terrain(40, word = { it % 7 })
        val plain = binary(facets)
        fun assertWhole() {
            assertSame()
            val count = stream().use { (it.loaded.scene.surfaces.single() as StreamedMesh).source.triangleCount }
            assertEquals(facets.size, count)
        }
        file.writeBytes(plain.copyOf().also { it.fill(0, 80, 84) })
        assertWhole()
        file.outputStream().use { out ->
            out.write(plain, 0, 84)
            for ((number, facet) in facets.withIndex()) {
                out.write(plain, 84 + 50 * number, 50)
                out.write(ByteArray(facet.word) { 0x7F })
            }
        }
        assertWhole()
    }

    @Test
    fun binaryFilesOfSeveralParts() {
        // A part has 8192 triangles
        for (side in listOf(1, 20, 63, 64, 110)) {
            file.writeBytes(binary(terrain(side)))
            assertSame(if (side == 20) all else listOf(TiledRenderer()))
        }
    }

    @Test
    fun coloursOfFacets() {
        val random = Random(1)
        file.writeBytes(binary(terrain(80) { if (it % 5 == 0) 0 else 0x8000 or random.nextInt(1 shl 15) }))
        assertSame()
        file.writeBytes(binary(terrain(80) { random.nextInt(1 shl 16) }, "x COLOR=\u0080\u0040\u00ff\u00ff"))
        assertSame()
        file.writeBytes(binary(terrain(80) { 1000 + it / 9000 }))
        assertSame()
    }

    @Test
    fun textOfSeveralSolids() {
        val finite = terrain(90).filter { facet -> facet.corners.all { it.isFinite() } }
        file.writeText(ascii(finite))
        assertSame(all)
        file.writeText(ascii(finite.take(5)).replace("\n", " ").replace("\r", " "))
        assertThrows(SceneFormatException::class.java) { stream() }
        file.writeText(ascii(finite.take(5)).replace("\n", "\r"))
        assertSame()
    }

    @Test
    fun aStreamIsCopied() {
        val bytes = binary(terrain(30))
        file.writeBytes(bytes)
        val expected = hashes(Scenes.load(file, LoadOptions(smoothNormals = false)), all)
        Scenes.stream(bytes.inputStream(), SceneFormat.STL, spool = spool).use { streamed ->
            assertEquals(expected, hashes(streamed.loaded, all))
            assertEquals(1, spool.listDirectoryEntries().size)
            streamed.close()
        }
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries())
    }

    private fun assertRefused(vararg words: String, limits: LoadLimits = LoadLimits()) {
        val refused = assertThrows(SceneFormatException::class.java) { stream(limits).close() }
        for (word in words) assertTrue(word in refused.message!!, refused.message)
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    @Test
    fun badFilesAreRefused() {
        assertRefused("no such file")
        file.writeText("")
        assertRefused("is empty")
        file.writeBytes(binary(terrain(9)).copyOf(1000))
        assertRefused("byte 1000", "ends within facet 18 of the 180")
        file.writeBytes(ByteArray(50))
        assertRefused("byte 50", "ends within the header")
        file.writeText("solid x\nfacet normal 0 0 1\nouter loop\nvertex 1 2 three\n")
        assertRefused("line 4", "three")
        file.writeText(ascii(terrain(5).take(3)).substringBeforeLast("endfacet"))
        assertRefused("the file ends where")
        file.writeBytes(byteArrayOf(-1, -2) + "solid".toByteArray(Charsets.UTF_16LE))
        assertRefused("byte order mark")
        val off = folder.resolve("a.off")
        off.writeText("OFF\n0 0 0\n")
        val refused = assertThrows(SceneFormatException::class.java) { Scenes.stream(off, spool = spool) }
        assertTrue("only STL, PLY and OBJ can" in refused.message!!, refused.message)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun limitsApply() {
        val finite = terrain(100).filter { facet -> facet.corners.all { it.isFinite() } }
        val most = LoadLimits().withTriangles(9000)
        file.writeBytes(binary(finite))
        assertRefused("more than 9000 triangles", "--max-triangles", limits = most)
        file.writeText(ascii(finite))
        assertRefused("more than 9000 triangles", limits = most)

        // Each corner is a vertex of its own
        val vertices = LoadLimits().withVertices(3L * finite.size - 1)
        file.writeBytes(binary(finite))
        assertRefused("more than ${3 * finite.size - 1} vertices", "--max-vertices", limits = vertices)
        file.writeText(ascii(finite))
        assertRefused("more than ${3 * finite.size - 1} vertices", limits = vertices)
        stream(LoadLimits().withVertices(3L * finite.size)).close()

        // Decoded data is not kept, so its limit does not apply
        stream(LoadLimits().withDecodedBytes(1000)).close()
    }

    @Test
    fun aFileThatIsCutShortWhileItIsReadIsReported() {
        file.writeBytes(binary(terrain(50)))
        stream().use { streamed ->
            file.outputStream().use { it.write(1) }
            val refused =
                assertThrows(UncheckedIOException::class.java) { hashes(streamed.loaded, listOf(TiledRenderer())) }
            assertTrue(refused.cause is SceneReadException, "${refused.cause}")
            assertTrue("has become shorter" in refused.message!!, refused.message)
        }
    }
}
