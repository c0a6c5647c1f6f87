package dev.lazyz.scenes.streaming

import dev.lazyz.Renderer
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.material.Material.Shading
import java.io.ByteArrayInputStream
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** PLY and OBJ files that are read part by part show the same as files that are read whole. */
class StreamedIndexedTest {
    @TempDir
    lateinit var folder: Path

    private val spool: Path by lazy { folder.resolve("spool").also { it.toFile().mkdir() } }
    private val all: List<Renderer> = listOf(TiledRenderer(), ZBufferRenderer(), HybridRenderer())

    /** Pixels and depths of the flat picture. */
    private fun looks(loaded: LoadedScene, renderers: List<Renderer>): List<String> {
        val scene = loaded.scene.withSurfaces(
            loaded.scene.surfaces.map { surface -> surface.withMaterials { it.withShading(Shading.FLAT) } },
        )
        return renderers.map { renderer ->
            val image = renderer.render(scene.frame(90, 70))
            image.pixelHash() + image.depth.contentHashCode()
        }
    }

    private fun write(name: String, bytes: ByteArray): Path = folder.resolve(name).also { it.writeBytes(bytes) }

    private fun assertSame(file: Path, renderers: List<Renderer> = listOf(TiledRenderer()), vararg warnings: String) {
        val format = checkNotNull(SceneFormat.ofFileName("$file"))
        val whole = Scenes.load(file.readBytes(), format, "$file", LoadOptions(smoothNormals = false))
        val expected = looks(whole, renderers)
        val fromFile = Scenes.stream(file, spool = spool)
        val fromStream = Scenes.stream(ByteArrayInputStream(file.readBytes()), format, "$file", spool = spool)
        for (streamed in listOf(fromFile, fromStream)) {
            streamed.use {
                assertEquals(whole.scene.bounds.toString(), streamed.loaded.scene.bounds.toString())
                assertEquals(expected, looks(streamed.loaded, renderers))
                val all = if (warnings.isEmpty()) whole.warnings else warnings.map { "$file: $it" }
                assertEquals(all, streamed.loaded.warnings)
            }
        }
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    private fun assertRefused(file: Path, vararg words: String, limits: LoadLimits = LoadLimits()) {
        val refused = assertThrows(SceneFormatException::class.java) {
            Scenes.stream(file, limits = limits, spool = spool).close()
        }
        for (word in words) assertTrue(word in refused.message!!, refused.message)
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    private fun obj(text: String): Path = write("model.obj", text.toByteArray())

    private fun hills(side: Int, change: IndexedHills.() -> Unit = {}) = IndexedHills(side).apply(change)

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun objFilesOfSeveralParts() {
        for (side in listOf(1, 30, 150)) {
            assertSame(obj(hills(side).obj()), if (side == 30) all else listOf(TiledRenderer()))
        }
        assertSame(obj(hills(150) { lineEnd = "\r\n" }.obj()))
        assertSame(obj(hills(150) { lineEnd = " \\\r\n \r" }.obj()))
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun polygonsAreCutAsInMemory() {
        assertSame(obj(hills(60) { corners = 4 }.obj()), all)
        assertSame(write("model.ply", hills(60) { corners = 4 }.ply("ascii")), all)
        val star = "f " + (1..12).joinToString(" ") + "\n"
        val outline = (0 until 12).joinToString("") { i ->
            val radius = if (i % 2 == 0) 1.0 else 0.4
            val angle = i * StrictMath.PI / 6
            "v ${radius * StrictMath.cos(angle)} ${radius * StrictMath.sin(angle)} ${0.1 * i}\n"
        }
        assertSame(obj(outline + star))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun coloursOfVertices() {
        assertSame(obj(hills(90) { isColored = true }.obj()), all)
        assertSame(obj("v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nv 1 1 0 0 0.5 1\nv 2 2 0\nf 1 2 3\nf 4 3 5\n"), all)
        for (format in FORMATS) {
            assertSame(write("model.ply", hills(90) { isColored = true }.ply(format)), all)
            assertSame(write("model.ply", hills(40) { isColored = true }.ply(format, number = "double")))
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun coloursOfFaces() {
        for (format in FORMATS) {
            assertSame(write("model.ply", hills(50) { haveFacesColors = true }.ply(format)), all)
            assertSame(
                write(
                    "model.ply",
                    hills(9) {
                        haveFacesColors = true
                        isColored = true
                    }.ply(format)
                )
            )
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun modelsFarFromTheOrigin() {
        assertSame(obj(hills(90) { offset = 1e7 }.obj()))
        for (format in FORMATS) {
            assertSame(write("model.ply", hills(90) { offset = 1e7 }.ply(format, number = "double")))
            assertSame(
                write(
                    "model.ply",
                    hills(20) {
                        offset = 4096.0
                        isLast = true
                    }.ply(format)
                )
            )
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun plyFilesOfSeveralParts() {
        for (format in FORMATS) {
            for (side in listOf(1, 30, 200)) {
                assertSame(
                    write("model.ply", hills(side).ply(format)),
                    if (side ==
                        30
                    ) {
                        all
                    } else {
                        listOf(TiledRenderer())
                    }
                )
            }
            assertSame(write("model.ply", hills(120) { isLast = true }.ply(format)))
            assertSame(write("model.ply", hills(40).ply(format, number = "double")))
        }
    }

    @Test
    fun whatIsNotReadIsReported() {
        assertSame(
            obj("mtllib a.mtl\nvt 0 0\nvn 0 0 1\n" + hills(3).obj() + "usemtl a\ns 1\np 1 2\nl 1 2\ncstype x\nhello\n"),
            emptyList(),
            "free-form curves and surfaces are not drawn; their statements are passed over: 1 cstype",
            "unknown statements are passed over: 1 hello",
            "statements that are not used are passed over: 1 mtllib, 1 vt, 1 vn, 1 usemtl, 1 p, 1 l",
        )
        val normals = hills(20) { haveNormals = true }
        for (format in FORMATS) {
            assertSame(
                write("model.ply", normals.ply(format)), all,
                "properties that are not used: nx, ny, nz, u, v of 441 vertex",
            )
            assertSame(
                write("model.ply", hills(2) { hasEdge = true }.ply(format)), emptyList(),
                "properties that are not used: vertex1, vertex2 of 1 edge",
            )
        }
        assertSame(
            write("model.ply", "ply\nformat ascii 1.0\nelement vertex 0\n$XYZ\nend_header\n".toByteArray()),
            listOf(TiledRenderer()), "there are no vertices, so there is nothing to see",
        )
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun mistakesAreFoundAsInMemory() {
        val wrong = listOf(
            "model.obj" to "v 0 0\n", "model.obj" to "v 0 0 zero\n", "model.obj" to "f 1 2 3\n",
            "model.obj" to "v 0 0 0\nv 1 0 0\n\nf 1 2 3\n", "model.obj" to "v 0 0 0\nf -1 -2 -1\n",
            "model.obj" to "v 0 0 0\nf 1 1 0\n", "model.obj" to "v 0 0 0\nf 1/1/1/1 1 1\n",
            "model.obj" to "v 0 0 0\nf 1 x 1\n",
            "model.ply" to "plyx\n", "model.ply" to "ply\nformat ascii 1.0\n",
            "model.ply" to "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
            "model.ply" to "ply\nformat ascii 1.0\nelement vertex 1\n$XYZ\nend_header\n1 2\n",
            "model.ply" to "ply\nformat ascii 1.0\nelement vertex 1\n$XYZ\nend_header\n1 2 a\n",
            "model.ply" to "ply\nformat ascii 1.0\nelement vertex 1\n$XYZ\n$LIST\nend_header\n1 2 3\n3 0 0 1\n",
            "model.ply" to "ply\nformat ascii 1.0\nelement vertex 1\n$XYZ\n$LIST\nend_header\n1 2 3\n4 0 0\n",
            "model.ply" to "ply\nformat binary_little_endian 1.0\nelement vertex 1\n$XYZ\n$LIST\nend_header\n" +
                "\u0000".repeat(12) + "\u0003" + "\u0000".repeat(8) + "\u0001\u0000\u0000\u0000",
        )
        for ((name, text) in wrong) {
            val file = write(name, text.toByteArray(Charsets.ISO_8859_1))
            val inMemory = assertThrows(SceneFormatException::class.java, { Scenes.load(file) }, text)
            assertRefused(file, inMemory.message!!)
        }
        assertRefused(write("model.obj", byteArrayOf(-1, -2) + "v".toByteArray(Charsets.UTF_16LE)), "byte order mark")
        assertRefused(obj("v 0 0 0\n".padEnd(40_000_000, '1')), "line 2: the line has 33554432 bytes or more")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun limitsApply() {
        val few = LoadLimits().withVertices(20_000)
        val triangles = LoadLimits().withTriangles(40_000)
        for (file in listOf(obj(hills(150).obj())) + FORMATS.map { write("$it.ply", hills(150).ply(it)) }) {
            assertRefused(file, "more than 20000 vertices", "--max-vertices", limits = few)
            assertRefused(file, "more than 40000 triangles", "--max-triangles", limits = triangles)
            Scenes.stream(file, limits = LoadLimits().withDecodedBytes(1000), spool = spool).close()
        }
    }

    /** Changed bytes give a picture or an error about the file, and leave no temporary files. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun damagedFilesDoNoHarm() {
        val random = Random(7)
        val small = hills(8) { isColored = true }
        val files = listOf("model.obj" to small.obj().toByteArray()) +
            FORMATS.map { "model.ply" to small.ply(it) } +
            FORMATS.map { "model.ply" to hills(8) { areStrips = true }.ply(it) }
        repeat(400) { round ->
            val (name, bytes) = files[round % files.size]
            val damaged = bytes.copyOf(if (round % 3 == 0) random.nextInt(bytes.size) + 1 else bytes.size)
            repeat(1 + random.nextInt(4)) { damaged[random.nextInt(damaged.size)] = random.nextInt(256).toByte() }
            val file = write(name, damaged)
            try {
                Scenes.stream(file, spool = spool).use { TiledRenderer().render(it.loaded.scene.frame(9, 9)) }
            } catch (_: SceneFormatException) {
                // An answer
            }
            assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
        }
    }

    private companion object {
        val FORMATS = listOf("ascii", "binary_little_endian", "binary_big_endian")
        const val XYZ = "property float x\nproperty float y\nproperty float z"
        const val LIST = "element face 1\nproperty list uchar int vertex_indices"
    }
}
