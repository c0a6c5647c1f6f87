package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.Scenes
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.strategies.hybrid.Hybrid
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.strategies.zbuffer.ZBuffer
import dev.lazyz.world.surface.StreamedMesh
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** OBJ and PLY files, whose triangles share vertices, show the same read part by part as read whole. */
class IndexedStreamTest {
    @TempDir
    lateinit var folder: Path

    private val spool: Path by lazy { folder.resolve("spool").also { it.toFile().mkdir() } }
    private val ply get() = folder.resolve("model.ply")
    private val obj get() = folder.resolve("model.obj")

    /** Vertices with x, y, z, and faces with any number of corners. */
    private class Model(val points: List<DoubleArray>, val faces: List<List<Int>>) {
        fun moved(offset: Double) = Model(points.map { doubleArrayOf(it[0] + offset, it[1], it[2]) }, faces)

        fun reversed() = Model(points, faces.map { it.reversed() })

        /** A colour of vertex or face [number]; three codes. */
        fun code(number: Int, channel: Int): Int = (37 * number + 91 * channel) % 256
    }

    /** A hilly square of [side] x [side] cells: triangles, quadrilaterals, a concave face, and strange ones. */
    private fun hills(side: Int): Model {
        val points = ArrayList<DoubleArray>()
        for (y in 0..side) {
            for (x in 0..side) {
                val z = StrictMath.sin(9.0 * x / side) * StrictMath.cos(7.0 * y / side) / 5
                points += doubleArrayOf(x.toDouble() / side, y.toDouble() / side, if (x == 3) -0.0 else z)
            }
        }
        val faces = ArrayList<List<Int>>()
        fun at(x: Int, y: Int) = y * (side + 1) + x
        for (y in 0 until side) {
            for (x in 0 until side) {
                if ((x + y) % 3 == 0) {
                    faces += listOf(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1))
                } else {
                    faces += listOf(at(x, y), at(x + 1, y), at(x + 1, y + 1))
                    faces += listOf(at(x, y), at(x + 1, y + 1), at(x, y + 1))
                }
                if (x == y) faces += listOf(at(x, y), at(side - x, y), at(x, y))
            }
        }

        // An arrow, whose second corner is concave, and a vertex that is not used
        val first = points.size
        points += doubleArrayOf(0.2, 0.2, 0.5)
        points += doubleArrayOf(0.5, 0.3, 0.5)
        points += doubleArrayOf(0.8, 0.2, 0.5)
        points += doubleArrayOf(0.5, 0.9, 0.5)
        points += doubleArrayOf(1.5, 1.0, 0.1)
        faces += listOf(first, first + 1, first + 2, first + 3)
        return Model(points, faces)
    }

    private enum class Form(val id: String, val order: ByteOrder?) {
        ASCII("ascii", null),
        LITTLE("binary_little_endian", ByteOrder.LITTLE_ENDIAN),
        BIG("binary_big_endian", ByteOrder.BIG_ENDIAN),
    }

    /** How a PLY file is written. */
    private class Ply(
        val form: Form = Form.LITTLE,
        val type: String = "float",
        val hasVertexColors: Boolean = false,
        val hasFaceColors: Boolean = false,
        val facesFirst: Boolean = false,
        val extra: String = "",
    )

    private fun ply(model: Model, how: Ply): ByteArray {
        val out = ByteArrayOutputStream()
        val vertexHeader = "element vertex ${model.points.size}\n" +
            listOf("x", "y", "z").joinToString("") { "property ${how.type} $it\n" } +
            (if (how.hasVertexColors) COLORS else "") + how.extra
        val faceHeader = "element face ${model.faces.size}\nproperty list uchar int vertex_indices\n" +
            (if (how.hasFaceColors) COLORS else "")
        val headers = if (how.facesFirst) listOf(faceHeader, vertexHeader) else listOf(vertexHeader, faceHeader)
        out.write("ply\nformat ${how.form.id} 1.0\n${headers.joinToString("")}end_header\n".toByteArray())
        val numbers = ByteBuffer.allocate(1 shl 16)
        fun write(type: String, value: Number) {
            if (how.form.order == null) return out.write("$value ".toByteArray())
            numbers.clear().order(how.form.order)
            when (type) {
                "float" -> numbers.putFloat(value.toFloat())
                "double" -> numbers.putDouble(value.toDouble())
                "int" -> numbers.putInt(value.toInt())
                else -> numbers.put(value.toByte())
            }
            out.write(numbers.array(), 0, numbers.position())
        }
        fun endRow() = if (how.form.order == null) out.write('\n'.code) else Unit
        fun colors(number: Int) = repeat(3) { write("uchar", model.code(number, it)) }
        val vertices = {
            for ((number, point) in model.points.withIndex()) {
                for (c in point) write(how.type, if (how.type == "float") c.toFloat() else c)
                if (how.hasVertexColors) colors(number)
                if (how.extra.isNotEmpty()) write("float", 0.5f)
                endRow()
            }
        }
        val faces = {
            for ((number, face) in model.faces.withIndex()) {
                write("uchar", face.size)
                for (corner in face) write("int", corner)
                if (how.hasFaceColors) colors(number)
                endRow()
            }
        }
        for (part in if (how.facesFirst) listOf(faces, vertices) else listOf(vertices, faces)) part()
        return out.toByteArray()
    }

    private fun obj(model: Model, color: Boolean = false, reference: (Int) -> String = { "${it + 1}" }): String =
        buildString {
            for ((number, point) in model.points.withIndex()) {
                append("v ${point[0]} ${point[1]} ${point[2]}")
                if (color && number > 70) append(" 0.${number % 10} 0.5 1")
                append("\n")
            }
            for (face in model.faces) append("f ${face.joinToString(" ", transform = reference)}\n")
        }

    private fun stream(file: Path, limits: LoadLimits = LoadLimits()): StreamedScene =
        Scenes.stream(file, limits = limits, spool = spool)

    private fun hash(loaded: LoadedScene): String = Tiled().render(loaded.scene.frame(90, 70)).pixelHash()

    private fun assertSame(file: Path, what: String = "") {
        val whole = Scenes.load(file, LoadOptions(smoothNormals = false))
        stream(file).use { streamed ->
            assertEquals(whole.scene.bounds.toString(), streamed.loaded.scene.bounds.toString(), what)
            assertEquals(hash(whole), hash(streamed.loaded), what)
            assertEquals(whole.warnings, streamed.loaded.warnings, what)
        }
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    @Test
    fun plyInAllForms() {
        for (form in Form.entries) {
            for (how in listOf(
                Ply(form), Ply(form, hasVertexColors = true), Ply(form, hasFaceColors = true),
                Ply(form, hasVertexColors = true, hasFaceColors = true, facesFirst = true), Ply(form, "double"),
                Ply(form, facesFirst = true), Ply(form, extra = "property float quality\n"),
            )) {
                ply.writeBytes(ply(hills(17), how))
                assertSame(ply, "$form ${how.type} ${how.hasVertexColors} ${how.hasFaceColors} ${how.facesFirst}")
            }
        }
    }

    @Test
    fun manyParts() {
        val model = hills(190)
        for (form in Form.entries) {
            ply.writeBytes(ply(model, Ply(form)))
            assertSame(ply)
        }
        obj.writeText(obj(model))
        assertSame(obj)
    }

    @Test
    fun allStrategies() {
        ply.writeBytes(ply(hills(30), Ply(hasVertexColors = true)))
        val expected = hash(Scenes.load(ply, LoadOptions(smoothNormals = false)))
        stream(ply).use { streamed ->
            for (renderer in listOf(ZBuffer(), Hybrid())) {
                assertEquals(expected, renderer.render(streamed.loaded.scene.frame(90, 70)).pixelHash())
            }
        }
    }

    @Test
    fun farFromTheOriginDetailsAreKept() {
        ply.writeBytes(ply(hills(20).moved(4e6), Ply(type = "double")))
        assertSame(ply)
        obj.writeText(obj(hills(20).moved(4e6)))
        assertSame(obj)
        stream(obj).use { streamed ->
            val mesh = streamed.loaded.scene.surfaces.single() as StreamedMesh
            assertTrue(mesh.origin.x() > 3.9e6, "${mesh.origin}")
        }
    }

    @Test
    fun objWithColoursOfVertices() {
        obj.writeText(obj(hills(80), color = true))
        assertSame(obj)
    }

    @Test
    fun objThatCountsBackward() {
        val model = hills(20)
        obj.writeText(obj(model) { "${it - model.points.size}" })
        assertSame(obj)
    }

    @Test
    fun objWhoseFacesStandBeforeTheirVertices() {
        val (vertices, faces) = obj(hills(70)).lines().partition { it.startsWith("v") }
        obj.writeText((faces.take(5000) + vertices.take(3000) + faces.drop(5000) + vertices.drop(3000)).joinToString("\n"))
        assertSame(obj)
        obj.writeText((vertices.take(5000) + faces + vertices.drop(5000)).joinToString("\n"))
        assertSame(obj)
    }

    @Test
    fun objWithContinuedLinesAndComments() {
        val text = obj(hills(60)).replace("\nf ", "# no\r\n\r\nf \\\r\n ")
        obj.writeText(text)
        assertSame(obj)
        obj.writeText(text.dropLast(1) + " \\")
        assertSame(obj)
    }

    @Test
    fun whatIsNotUsedIsReported() {
        obj.writeText("vn 0 0 1\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1/1/1 2/1/1 3/1/1\np 1\ncurv 1 2\n")
        stream(obj).use { streamed ->
            assertEquals(
                listOf(
                    "$obj: free-form curves and surfaces are not drawn; their statements are passed over: 1 curv",
                    "$obj: is read part by part, without its normals, texture coordinates, materials, points and lines",
                ),
                streamed.loaded.warnings,
            )
        }
        ply.writeText(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n" +
                "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
                "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
                "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 0 0\n0 1 0 0 0 1 0 0\n3 0 1 2 6 0 0 1 1 0 1\n2 0 1 0\n0 1\n",
        )
        stream(ply).use { streamed ->
            assertEquals(
                listOf(
                    "$ply: 1 faces of fewer than 3 corners are left out",
                    "$ply: properties that are not used: nx, ny, nz, s, t of 3 vertex; texcoord of 2 face; " +
                        "vertex1, vertex2 of 1 edge",
                ),
                streamed.loaded.warnings,
            )
        }
    }

    @Test
    fun filesThatAreCutShort() {
        for (form in Form.entries) {
            // A line of text that ends within a list is refused if it has more than the list
            val colored = Ply(form, hasVertexColors = true, hasFaceColors = true).takeIf { form != Form.ASCII }
            for (how in listOfNotNull(Ply(form), colored)) {
                val bytes = ply(hills(20), how)
                for (count in listOf(bytes.size * 9 / 10, bytes.size - 3)) {
                    ply.writeBytes(bytes.copyOf(count))
                    assertSame(ply, "$form $count")
                }
                ply.writeBytes(bytes.copyOf(1000))
                assertRefused(ply, "has no faces", "read it whole")
            }
        }
        val facesFirst = ply(hills(20), Ply(facesFirst = true))
        ply.writeBytes(facesFirst.copyOf(facesFirst.size - 100))
        assertSame(ply)
    }

    private fun assertRefused(file: Path, vararg words: String, limits: LoadLimits = LoadLimits()) {
        val refused = assertThrows(SceneFormatException::class.java) { stream(file, limits).close() }
        for (word in words) assertTrue(word in refused.message!!, refused.message)
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries(), "temporary files")
    }

    /** The message is that of the whole file, too. */
    private fun assertRefusedAsWhole(file: Path, vararg words: String) {
        assertRefused(file, *words)
        val whole = assertThrows(SceneFormatException::class.java) { Scenes.load(file) }
        val streamed = assertThrows(SceneFormatException::class.java) { stream(file) }
        assertEquals(whole.message, streamed.message)
    }

    @Test
    fun badFilesAreRefused() {
        obj.writeText("v 0 0 0\nv 1 0 0\nv 1 1 zero\n")
        assertRefusedAsWhole(obj, "line 3", "zero")
        obj.writeText("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\n")
        assertRefusedAsWhole(obj, "line 5", "number 4 of 3 vertices")
        obj.writeText("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 -4\n")
        assertRefusedAsWhole(obj, "line 4", "-4")
        obj.writeText("# nothing\n")
        assertRefusedAsWhole(obj, "no vertex")
        obj.writeText("v 0 0 0\np 1\n")
        assertRefused(obj, "has no faces", "read it whole")
        obj.writeBytes(byteArrayOf(-1, -2) + "v 0".toByteArray(Charsets.UTF_16LE))
        assertRefused(obj, "byte order mark")
        ply.writeText("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n")
        assertRefusedAsWhole(ply, "no property y")
        ply.writeText("ply\nformat ascii 1.0\n" + "comment long\n".repeat(9000) + "end_header\n")
        assertRefused(ply, "header", "is longer than")
        val bytes = ply(hills(3), Ply())
        val face = bytes.size - 4
        ply.writeBytes(bytes.copyOf().also { it[face + 3] = 1 })
        assertRefusedAsWhole(ply, "byte ${bytes.size}", "is not one of the 21 vertices")
        ply.writeBytes(ply(Model(hills(3).points, emptyList()), Ply()))
        assertRefused(ply, "has no faces", "read it whole")
    }

    @Test
    fun limitsApply() {
        ply.writeBytes(ply(hills(60), Ply()))
        obj.writeText(obj(hills(60)))
        for (file in listOf(ply, obj)) {
            assertRefused(file, "more than 7000 triangles", limits = LoadLimits().withTriangles(7000))
            assertRefused(file, "more than 3000 vertices", limits = LoadLimits().withVertices(3000))

            // Decoded data is not kept, so its limit does not apply
            stream(file, LoadLimits().withDecodedBytes(1000)).close()
        }
    }

    @Test
    fun streamsAreCopied() {
        val bytes = ply(hills(30), Ply(Form.BIG))
        ply.writeBytes(bytes)
        val expected = hash(Scenes.load(ply, LoadOptions(smoothNormals = false)))
        Scenes.stream(bytes.inputStream(), SceneFormat.PLY, spool = spool).use { streamed ->
            assertEquals(expected, hash(streamed.loaded))
        }
        assertEquals(emptyList<Path>(), spool.listDirectoryEntries())
    }

    private companion object {
        const val COLORS = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    }
}
