package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PlyErrorsTest {
    private val header = "ply\nformat FORMAT 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" +
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    private val body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"

    private fun file(format: PlyFormat, face: List<Int> = listOf(0, 1, 2)) = PlyFiles.of(
        format,
        header,
        listOf(
            "float float float" to listOf(listOf(0, 0, 0), listOf(1, 0, 0), listOf(0, 1, 0)),
            "uchar/int" to listOf(listOf(face)),
        ),
    )

    private fun assertFails(text: String, location: String?, vararg parts: String) =
        assertFails(text.toByteArray(), location, *parts)

    private fun assertFails(bytes: ByteArray, location: String?, vararg parts: String) {
        val error = TestSources.error(PlyParser, TestSources.of(bytes))
        assertEquals(location, error.location, error.message)
        for (part in parts) assertTrue(part in error.message!!, "\"$part\" in: ${error.message}")
    }

    private fun ascii(header: String = this.header, body: String = this.body) = header.replace("FORMAT", "ascii") + body

    @Test
    fun headerErrorsNameTheirLine() {
        assertFails("plyx\n", "line 1", "begins with")
        assertFails("ply\nformat ascii 1.0\n", "line 2", "before end_header")
        assertFails(ascii(header.replace("1.0", "2.0")), "line 2", "\"2.0\"")
        assertFails(header.replace("FORMAT", "binary"), "line 2", "\"binary\"", "binary_big_endian")
        assertFails(ascii(header.replace("float y", "real y")), "line 5", "\"real\"")
        assertFails(ascii(header.replace("vertex 3", "vertex -3")), "line 3", "-3")
        assertFails(ascii(header.replace("vertex 3", "vertex 3000000000")), "line 3", "3000000000")
        assertFails(ascii(header.replace("element face", "elem face")), "line 7", "\"elem\"")
        assertFails(ascii(header.replace("element face", "element vertex")), "line 7", "second element vertex")
        assertFails(ascii(header.replace("element vertex", "element point")), "line 9", "no element vertex")
        assertFails(ascii(header.replace("property float z\n", "")), "header", "no property z")
        assertFails(ascii(header.replace("vertex_indices", "corners")), "header", "no list vertex_indices")
    }

    @Test
    fun bodyErrorsNameTheirLine() {
        assertFails(ascii(body = body.replace("1 0 0", "1 0")), "line 11", "property z")
        assertFails(ascii(body = body.replace("1 0 0", "1 0 x")), "line 11", "\"x\"")
        assertFails(ascii(body = body.replace("1 0 0", "1,5 0 0")), "line 11", "decimal point")
        assertFails(ascii(body = body.replace("3 0 1 2", "3 0 1 3")), "line 13", "vertex number 3", "3 vertices")
        assertFails(ascii(body = body.replace("3 0 1 2", "3 0 1 -1")), "line 13", "vertex number -1")
        assertFails(ascii(body = body.replace("3 0 1 2", "3 0 1 1.5")), "line 13", "vertex number 1.5")
        assertFails(ascii(body = body.replace("3 0 1 2", "4 0 1 2")), "line 13", "announces 4 numbers")
        assertFails(ascii(body = body.replace("3 0 1 2", "-1 0 1 2")), "line 13", "-1")
    }

    @Test
    fun binaryErrorsNameTheirByte() {
        val wrong = file(PlyFormat.BIG_ENDIAN, listOf(0, 1, 9))
        assertFails(wrong, "byte ${wrong.size}", "vertex number 9")
    }

    @Test
    fun hugeCountsAreNotBelieved() {
        for (format in PlyFormat.entries) {
            for (element in listOf("vertex 3", "face 1")) {
                val huge = element.substringBefore(' ') + " 2000000000"
                val text = header.replace("FORMAT", format.id).replace(element, huge)
                val rows = if (format == PlyFormat.ASCII) body.toByteArray() else ByteArray(1000)
                val warnings = warnings(text.toByteArray() + rows)
                assertTrue(warnings.any { "of 2000000000" in it }, "$format $warnings")
            }
        }
        val list = header.replace("FORMAT", "binary_big_endian").replace("uchar int", "uint double").toByteArray() +
            ByteArray(36) + ByteArray(4) { -1 }
        assertEquals(cutShort(3, 0), warnings(list)[0])
    }

    private fun warnings(bytes: ByteArray): List<String> = TestSources.of(bytes).also(PlyParser::parse).warnings

    private fun cutShort(vertices: Int, faces: Int) = "test: the file is cut short and has only these rows: " +
        "$vertices of 3 vertex, $faces of 1 face; export or copy the model again"

    @Test
    fun whatIsThereOfAFileThatIsCutShortIsShown() {
        for (format in PlyFormat.entries) {
            val start = header.replace("FORMAT", format.id).length
            val whole = file(format)
            assertEquals(emptyList<String>(), warnings(whole), "$format")
            for (length in start until whole.size - 1) {
                val rows = if (format == PlyFormat.ASCII) (length - start) / 6 else (length - start) / 12
                assertEquals(cutShort(minOf(rows, 3), 0), warnings(whole.copyOf(length))[0], "$format $length")
            }
        }

        // A last line needs no line end, but must be the last row
        assertEquals(emptyList<String>(), warnings(ascii().trimEnd().toByteArray()))
        val two = header.replace("face 1", "face 3") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0"
        val source = TestSources.of(two.replace("FORMAT", "ascii"))
        assertEquals(1, PlyParser.parse(source).meshes.single().triangleCount)
        assertTrue("3 of 3 vertex, 1 of 3 face" in source.warnings.single(), source.warnings.toString())
    }

    @Test
    fun facesWhoseVerticesAreCutOffAreLeftOut() {
        val text = "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_index\nelement vertex 4\n" +
            "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n3 1 2 3\n0 0 0\n1 0 0\n0 1 0\n"
        val source = TestSources.of(text)
        assertEquals(1, PlyParser.parse(source).meshes.single().triangleCount)
        assertTrue("2 of 2 face, 3 of 4 vertex" in source.warnings[0], source.warnings.toString())
        assertTrue("1 faces are left out" in source.warnings[1], source.warnings.toString())
    }
}
