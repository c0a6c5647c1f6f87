package dev.lazyz.scenes.ply

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Colours and texture coordinates of faces. */
class PlyFaceLooksTest {
    private val square = listOf(listOf(0, 0, 0), listOf(1, 0, 0), listOf(1, 1, 0), listOf(0, 1, 0))

    private fun file(
        format: PlyFormat,
        properties: List<String>,
        types: String,
        rows: List<List<Any>>,
        comments: List<String> = emptyList(),
    ): ByteArray {
        val lines = comments.map { "comment $it" } + "element vertex 4" + "property float x" + "property float y" +
            "property float z" + "element face ${rows.size}" + properties.map { "property $it" } + "end_header"
        val header = "ply\nformat FORMAT 1.0\n" + lines.joinToString("") { "$it\n" }
        return PlyFiles.of(format, header, listOf("float float float" to square, types to rows))
    }

    private fun Mesh.cornerColors() = triangles.map { colors!!.slice(4 * it until 4 * it + 4) }

    private fun Mesh.cornerUvs() = triangles.map { uvs!!.slice(2 * it until 2 * it + 2) }

    private fun color(argb: Long) = Rgba.ofArgb(argb.toInt()).let { listOf(it.red, it.green, it.blue, it.alpha) }

    @Test
    fun facesHaveColours() {
        for (type in listOf("uchar", "ushort", "float")) {
            val most = mapOf("uchar" to 255, "ushort" to 65535, "float" to 1).getValue(type)
            val properties = listOf("list uchar int vertex_indices", "$type red", "$type green", "$type blue")
            val rows = listOf(listOf(listOf(0, 1, 2), most, 0, 0), listOf(listOf(0, 2, 3), 0, 0, most))
            for (format in PlyFormat.entries) {
                val source = TestSources.of(file(format, properties, "uchar/int $type $type $type", rows))
                val mesh = PlyParser.parse(source).meshes.single()
                val expected = List(3) { color(0xFFFF0000) } + List(3) { color(0xFF0000FF) }
                assertEquals(expected, mesh.cornerColors(), "$format $type")
                assertEquals(listOf(0, 1, 2, 0, 2, 3).map { n -> square[n].map { it.toFloat() } }, mesh.corners())
                assertEquals(List(mesh.vertexCount) { listOf(0f, 0f, 1f) }, mesh.normals!!.toList().chunked(3))
                assertEquals(emptyList<String>(), source.warnings)
            }
        }
    }

    private val wedges = listOf("list uchar int vertex_indices", "list uchar float texcoord")

    private fun texture(folder: Path, name: String) =
        Files.write(folder.resolve(name), PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9))))

    @Test
    fun cornersHaveTextureCoordinates(@TempDir folder: Path) {
        texture(folder, "a b.png")
        val rows = listOf(
            listOf(listOf(0, 1, 2), listOf(0, 0, 1, 0, 1, 0.75)),
            listOf(listOf(0, 2, 3), listOf(0.5, 0, 1, 0.75, 0, 1)),
        )
        for (format in PlyFormat.entries) {
            val bytes = file(format, wedges, "uchar/int uchar/float", rows, listOf("TextureFile a b.png"))
            val source = TestSources.of(bytes, folder)
            val mesh = PlyParser.parse(source).meshes.single()
            val expected = listOf(0f to 1f, 1f to 1f, 1f to 0.25f, 0.5f to 1f, 1f to 0.25f, 0f to 0f)
            assertEquals(expected.map { it.toList() }, mesh.cornerUvs(), "$format")
            assertEquals(5, mesh.vertexCount)
            assertNotNull(mesh.material.texture)
            assertEquals(emptyList<String>(), source.warnings)
        }
    }

    @Test
    fun textureNumbersChooseAmongTextures(@TempDir folder: Path) {
        for (name in listOf("m_A.png", "m_B.png")) texture(folder, name)
        val uvs = listOf(0, 0, 1, 0, 1, 1)
        val rows = listOf(1, 0, -1, 7, 1).map { listOf(listOf(0, 1, 2), uvs, it) }
        val comments = listOf("TextureFile <this>_A.png", "TextureFile <this>_B.png")
        val bytes = file(PlyFormat.ASCII, wedges + "int texnumber", "uchar/int uchar/float int", rows, comments)
        val meshes = PlyParser.parse(Source(bytes, "some/m.ply", folder)).meshes
        assertEquals(listOf("m_B.png", "m_A.png", null, null), meshes.map { it.material.texture?.name })
        assertEquals(listOf(2, 1, 1, 1), meshes.map { it.triangleCount })
    }

    @Test
    fun wrongTextureCoordinatesGiveOneWarning() {
        val rows = listOf(
            listOf(listOf(0, 1, 2), listOf(0, 0, 1)),
            listOf(listOf(0, 2, 3), listOf<Int>()),
            listOf(listOf(0, 1, 2, 3), listOf(0, 0, 1, 0, 1, 1)),
        )
        val source = TestSources.of(file(PlyFormat.BIG_ENDIAN, wedges, "uchar/int uchar/float", rows))
        val mesh = PlyParser.parse(source).meshes.single()
        assertNull(mesh.uvs)
        assertEquals(4, mesh.triangleCount)
        assertEquals("test: 2 faces have a texcoord list that is not two numbers a corner", source.warnings.single())
    }

    @Test
    fun whatIsNotUsedIsListed() {
        val text =
            "ply\nformat ascii 1.0\nelement camera 1\nproperty float view\nelement vertex 3\nproperty float x\n" +
                "property float y\nproperty float z\nproperty float confidence\nproperty uchar red\nelement face 1\n" +
                "property list uchar int vertex_indices\nproperty int texnumber\nelement empty 0\nproperty int a\n" +
                "end_header\n1\n0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n3 0 1 2 0\n"
        val source = TestSources.of(text)
        PlyParser.parse(source)
        val expected = "view of 1 camera; confidence, red of 3 vertex; texnumber of 1 face"
        assertEquals(listOf("test: properties that are not used: $expected"), source.warnings)
    }
}
