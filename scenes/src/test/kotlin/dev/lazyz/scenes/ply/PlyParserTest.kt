package dev.lazyz.scenes.ply

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.meshes.AwkwardMesh
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class PlyParserTest {
    private val square = listOf(listOf(0, 0, 0), listOf(1, 0, 0), listOf(1, 1, 0), listOf(0, 1, 0))

    private fun header(vararg lines: String) =
        "ply\nformat FORMAT 1.0\n" + lines.joinToString("") { "$it\n" } + "end_header\n"

    private val plain = header(
        "element vertex 4", "property float x", "property float y", "property float z",
        "element face 1", "property list uchar int vertex_indices",
    )

    private val tables = listOf("float float float" to square, "uchar/int" to listOf(listOf(listOf(0, 1, 2, 3))))

    private fun plain(format: PlyFormat) = PlyFiles.of(format, plain, tables)

    private fun mesh(bytes: ByteArray): Mesh = PlyParser.parse(TestSources.of(bytes)).meshes.single()

    private fun mesh(text: String): Mesh = mesh(text.toByteArray())

    private fun ascii(header: String, body: String) = header.replace("FORMAT", "ascii") + body

    @Test
    fun allFormsGiveTheSameMesh() {
        for (format in PlyFormat.entries) {
            val mesh = mesh(plain(format))
            assertArrayEquals(intArrayOf(0, 1, 2, 0, 2, 3), mesh.triangles, "$format")
            assertEquals(square.flatten().map { it.toFloat() }, mesh.positions.toList(), "$format")
            assertEquals(listOf(0f, 0f, 1f), mesh.normals!!.take(3), "$format")
        }
    }

    /** Tables of floats, codes and lists of 32 bits are read straight from the bytes, others number by number. */
    @Test
    fun bothWaysToReadBinaryTablesAgree() {
        val head = header(
            "element vertex 6", "property FLOATS x", "property uchar red", "property FLOATS y", "property FLOATS z",
            "property uchar green", "property uchar blue", "property FLOATS nx", "property FLOATS ny",
            "property FLOATS nz", "property FLOATS s", "property FLOATS t", "property uchar alpha",
            "element face 4", "property list uchar INTS vertex_indices",
        )
        val far = listOf(0.0, 70000.0)
        for (offset in far) {
            val vertices = List(6) {
                val x = offset + it % 3
                listOf(x, 20 * it, 0.1f * it, it, 255 - it, it * 3, -0.0f, 0.5f, Float.NaN, 0.25f, 0.75f, 40 * it)
            }
            val faces = listOf(listOf(0, 1, 2), listOf(0, 1), listOf(0, 1, 4, 3), listOf(5, 4, 3)).map { listOf(it) }
            val meshes = listOf("float" to "int", "double" to "int", "float" to "uint").flatMap { (float, int) ->
                val types = "F uchar F F uchar uchar F F F F F uchar".replace("F", float)
                val tables = listOf(types to vertices, "uchar/$int" to faces)
                val text = head.replace("FLOATS", float).replace("INTS", int)
                listOf(PlyFormat.LITTLE_ENDIAN, PlyFormat.BIG_ENDIAN).flatMap { format ->
                    val bytes = PlyFiles.of(format, text, tables)
                    listOf(mesh(bytes), mesh(bytes.copyOf(bytes.size - 5)), mesh(bytes.copyOf(bytes.size - 14)))
                }
            }
            for ((i, mesh) in meshes.withIndex()) {
                val first = meshes[i % 3]
                assertArrayEquals(first.positions, mesh.positions)
                assertArrayEquals(first.triangles, mesh.triangles)
                assertArrayEquals(first.normals, mesh.normals)
                assertArrayEquals(first.uvs, mesh.uvs)
                assertArrayEquals(first.colors, mesh.colors)
                assertEquals(first.origin, mesh.origin)
            }
            assertEquals(listOf(4, 3, 1), meshes.take(3).map { it.triangleCount })
            assertEquals(offset > 0.0, meshes[0].origin != Vector3d())
        }
    }

    @Test
    fun vertexNumbersOfBinaryListsAreChecked() {
        val head = header(
            "element vertex 4", "property float x", "property float y", "property float z",
            "element tristrips 1", "property list int int vertex_indices",
        )
        fun strip(vararg numbers: Int, format: PlyFormat = PlyFormat.LITTLE_ENDIAN) =
            PlyFiles.of(format, head, listOf(tables[0], "int/int" to listOf(listOf(numbers.toList()))))
        val ascii = mesh(strip(0, 1, 2, 3, -1, 3, 2, 1, format = PlyFormat.ASCII))
        assertArrayEquals(ascii.triangles, mesh(strip(0, 1, 2, 3, -1, 3, 2, 1)).triangles)
        for (wrong in listOf(4, -2, Int.MIN_VALUE)) {
            val error = TestSources.error(PlyParser, TestSources.of(strip(0, 1, wrong)))
            assertTrue("vertex number $wrong is not one of the 4 vertices" in error.message!!, error.message)
        }
        val faces = listOf(tables[0], "uchar/int" to listOf(listOf(listOf(0, 1, -1))))
        val error = TestSources.error(PlyParser, TestSources.of(PlyFiles.of(PlyFormat.BIG_ENDIAN, plain, faces)))
        assertTrue("vertex number -1 is not one" in error.message!!, error.message)
    }

    @Test
    fun everyTypeUnderBothNamesIsRead() {
        val limits = mapOf(
            PlyType.CHAR to listOf(-128, 127), PlyType.UCHAR to listOf(0, 255), PlyType.SHORT to listOf(-32768, 32767),
            PlyType.USHORT to listOf(0, 65535), PlyType.INT to listOf(Int.MIN_VALUE, Int.MAX_VALUE),
            PlyType.UINT to listOf(0, 4294967295L), PlyType.FLOAT to listOf(-1.5, 0.1f),
            PlyType.DOUBLE to listOf(1e-3, 1e30),
        )
        for ((type, numbers) in limits) {
            for ((format, name) in PlyFormat.entries.flatMap { format -> type.names.map { format to it } }) {
                val header = header(
                    "element vertex 2", "property $name x", "property float y", "property $name z",
                    "element face 1", "property list $name $name vertex_index",
                )
                val rows = numbers.map { listOf(it, 7, it) }
                val face = "$name/$name" to listOf(listOf(listOf(0, 1, 0)))
                val mesh = mesh(PlyFiles.of(format, header, listOf("$name float $name" to rows, face)))
                val read = mesh.triangles.map { mesh.positions.slice(3 * it until 3 * it + 3) }
                assertEquals(numbers.map { listOf(it.toFloat(), 7f, it.toFloat()) }, read.take(2), "$format $name")
            }
        }
    }

    @Test
    fun unknownElementsAndPropertiesArePassedOver() {
        val header = header(
            "comment made by hand", "obj_info nothing",
            "element camera 2", "property double view", "property list uchar short tags",
            "element vertex 4", "property list ushort float weights", "property float x", "property uchar flag",
            "property float y", "property float z",
            "element edge 1", "property int a", "property int b",
            "element face 1", "property float quality", "property list uchar uint vertex_index",
            "property list uchar float more",
            "element nothing 2000000000",
        )
        for (format in PlyFormat.entries) {
            val bytes = PlyFiles.of(
                format,
                header,
                listOf(
                    "double uchar/short" to listOf(listOf(1, listOf(1, 2, 3)), listOf(2, listOf<Int>())),
                    "ushort/float float uchar float float" to
                        square.map { (x, y, z) -> listOf(List(x + y) { 9 }, x, 200, y, z) },
                    "int int" to listOf(listOf(0, 1)),
                    "float uchar/uint uchar/float" to listOf(listOf(0.5, listOf(0, 1, 2, 3), listOf(1, 2))),
                ),
            )
            assertEquals(mesh(plain(format)).corners(), mesh(bytes).corners(), "$format")
        }
    }

    @Test
    fun stripsAlternateAndStartAgainAtMinusOne() {
        val header = header(
            "element vertex 5", "property float x", "property float y", "property float z",
            "element tristrips 1", "property list int int vertex_indices",
        )
        val rows = List(5) { listOf(it, it * it, 0) }
        val strip = listOf(listOf(listOf(0, 1, 2, 3, -1, 4, 3, 2, 2, 1)))
        for (format in PlyFormat.entries) {
            val mesh = mesh(PlyFiles.of(format, header, listOf("float float float" to rows, "int/int" to strip)))
            val expected = listOf(0, 1, 2, 2, 1, 3, 4, 3, 2)
            assertEquals(expected.map { it.toFloat() }, mesh.corners().map { it[0] }, "$format")
        }
    }

    @Test
    fun vertexNormalsAndTextureCoordinatesAreKept() {
        for ((u, v) in listOf("s" to "t", "u" to "v", "texture_u" to "texture_v")) {
            val header = header(
                "element vertex 3", "property float x", "property float y", "property float z", "property float nx",
                "property float ny", "property float nz", "property float $u", "property float $v",
                "element face 1", "property list uchar int vertex_indices",
            )
            val mesh = mesh(ascii(header, "0 0 0 0 1 0 0.25 0\n1 0 0 0 1 0 0 1\n0 1 0 1 0 0 0 0.75\n3 0 1 2\n"))
            assertEquals(listOf(0f, 1f, 0f, 0f, 1f, 0f, 1f, 0f, 0f), mesh.normals!!.toList())
            assertEquals(listOf(0.25f, 1f, 0f, 0f, 0f, 0.25f), mesh.uvs!!.toList())
        }
    }

    @Test
    fun coloursAreDecoded() {
        fun colours(type: String, row: String): List<Float> {
            val header = header(
                "element vertex 1", "property float x", "property float y", "property float z",
                "property $type red", "property $type green", "property $type blue", "property $type alpha",
                "element face 1", "property list uchar int vertex_indices",
            )
            return mesh(ascii(header, "0 0 0 $row\n3 0 0 0\n")).colors!!.toList()
        }
        val expected = Rgba.ofArgb(0x80FF6400.toInt()).let { listOf(it.red, it.green, it.blue, it.alpha) }
        assertEquals(expected, colours("uchar", "255 100 0 128"))
        val close = colours("float", "1 ${100 / 255.0} 0 ${128 / 255.0}")
        for (i in 0 until 4) assertEquals(expected[i], close[i], 1e-6f)
        assertEquals(listOf(1f, 0f, 1f, 1f), colours("ushort", "65535 0 65535 65535"))
        assertEquals(listOf(1f, 0f, 0f, 1f), colours("float", "7 -1 nan 1"))
    }

    @Test
    fun lineEndsOfAllKindsAreRead() {
        val text = String(plain(PlyFormat.ASCII))
        for (end in listOf("\r\n", "\r")) assertEquals(2, mesh(text.replace("\n", end)).triangleCount)
        val mac = plain.replace("FORMAT", "binary_little_endian").replace('\n', '\r')

        // The first number's first byte looks like the second half of a line end
        val body = PlyFiles.of(PlyFormat.LITTLE_ENDIAN, "", tables)
        body[0] = '\n'.code.toByte()
        assertEquals(2, mesh(mac.toByteArray() + body).triangleCount)
    }

    @Test
    fun textureIsTheOneThatTheCommentNames(@TempDir folder: Path) {
        Files.write(folder.resolve("my skin.png"), PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9))))
        val header = header(
            "comment TextureFile my skin.png", "element vertex 3", "property float x", "property float y",
            "property float z", "property float s", "property float t",
            "element face 1", "property list uchar int vertex_indices",
        )
        val text = ascii(header, "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n")
        assertNotNull(PlyParser.parse(TestSources.of(text, folder)).meshes.single().material.texture)
        val bare = String(plain(PlyFormat.ASCII)).replace("1.0\n", "1.0\ncomment TextureFile my skin.png\n")
        assertNull(PlyParser.parse(TestSources.of(bare, folder)).meshes.single().material.texture)
        val stream = TestSources.of(text)
        assertNull(PlyParser.parse(stream).meshes.single().material.texture)
        assertEquals(1, stream.warnings.size)
    }

    @Test
    fun anAwkwardMeshIsWholeInAllForms() {
        val header = header(
            "element vertex ${AwkwardMesh.positions.size / 3}",
            "property float x", "property float y", "property float z",
            "property float nx", "property float ny", "property float nz", "property float s", "property float t",
            "element face ${AwkwardMesh.triangles.size / 3}", "property list uchar int vertex_indices",
        )
        val places = AwkwardMesh.positions.toList().chunked(3)
        val rows = places.zip(AwkwardMesh.directions.toList().chunked(3)) { place, normal -> place + normal }
            .zip(AwkwardMesh.uvs.toList().chunked(2)) { numbers, uv -> numbers + uv }
        val tables = listOf(
            List(8) { "float" }.joinToString(" ") to rows,
            "uchar/int" to AwkwardMesh.triangles.toList().chunked(3) { listOf(it.toList()) },
        )
        for (format in PlyFormat.entries) {
            val mesh = mesh(PlyFiles.of(format, header, tables))
            assertEquals(AwkwardMesh.corners(AwkwardMesh.positions, 3), mesh.corners(), "$format")
            assertEquals(AwkwardMesh.directions.toList(), mesh.normals!!.toList(), "$format")
            val uvs = AwkwardMesh.uvs.mapIndexed { i, number -> if (i % 2 == 0) number else 1 - number }
            assertEquals(uvs, mesh.uvs!!.toList(), "$format")
        }
    }
}
