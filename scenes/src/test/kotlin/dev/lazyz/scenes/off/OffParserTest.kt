package dev.lazyz.scenes.off

import dev.lazyz.Rgba
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.FormatSniffer
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class OffParserTest {
    private val square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"

    private fun mesh(text: String, warnings: Int = 0): Mesh {
        val source = TestSources.of(text)
        val mesh = OffParser.parse(source).meshes.single()
        assertEquals(warnings, source.warnings.size, source.warnings.toString())
        return mesh
    }

    /** The colours of each triangle's corners, as codes. */
    private fun Mesh.codes(): List<List<String>> = triangles.toList().chunked(3) { corners ->
        corners.map { vertex ->
            val (r, g, b, a) = colors!!.slice(4 * vertex until 4 * vertex + 4)
            "%08X".format(Rgba(r, g, b, a).toArgb())
        }.distinct()
    }

    @Test
    fun verticesOfAFarModelCountOnce() {
        val text = "OFF\n3 1 0\n9000 0 0 7\n9001 0 0\n9001 1 0\n3 0 1 2\n"
        val source =
            Source(text.toByteArray(), "a", null, Loading(LoadOptions(LoadLimits(vertices = 3, triangles = 1))))
        assertEquals(9000.5, OffParser.parse(source).meshes.single().origin.x())
        assertEquals(1, source.warnings.size, "${source.warnings}")
    }

    @Test
    fun headersOfAllFormsAreRead() {
        val expected = mesh("OFF\n4 1 0\n${square}4 0 1 2 3\n").corners()
        assertEquals(2, expected.size / 3)
        val commented = "# a\n\n OFF # b\n# c\n\n4 1 # d\n"
        val headers = listOf("OFF 4 1 0\n", "OFF4 1 0\n", "4 1\n", "OFF\n4 1\n", commented, "off\r4 1 9\r")
        for (header in headers) {
            assertEquals(expected, mesh("$header${square}4 0 1 2 3").corners(), header)
            if (header != "4 1\n" && '#' !in header) {
                assertEquals(SceneFormat.OFF, FormatSniffer.format((header + square).toByteArray()), header)
            }
        }
        assertEquals(listOf(0f, 0f, 1f), mesh("OFF 4 1\n${square}4 0 1 2 3").normals!!.take(3))
    }

    @Test
    fun aLongFirstWordTakesNoStack() {
        assertTrue(OffHeader.isKeyword("ST".repeat(100_000) + "OFF"))
        assertFalse(OffHeader.isKeyword("ST".repeat(100_000) + "OF"))
    }

    @Test
    fun verticesHaveWhatTheHeaderSays() {
        val vertices = "0 0 0 0 1 0 255 0 0 0.25 1\n1 0 0 0 1 0 0 0 255 128 0 0.75\n0 1 0 0 1 0 0 255 0 1 0\n"
        for (header in listOf("STCNOFF", "NCSTOFF")) {
            val mesh = mesh("$header\n3 1 0\n${vertices}3 0 1 2\n")
            assertEquals(listOf(0f, 1f, 0f), mesh.normals!!.take(3))
            assertEquals(listOf(0.25f, 0f, 0f, 0.25f, 1f, 1f), mesh.uvs!!.toList())
            assertEquals(listOf(listOf("FFFF0000", "800000FF", "FF00FF00")), mesh.codes())
        }
        val plain = mesh("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 0.5 0 1\n0 1 0\n3 0 1 2\n", warnings = 0)
        assertEquals(listOf(listOf("FFFF0000", "FF008000", "FFFFFFFF")), plain.codes())
    }

    @Test
    fun facesHaveColours() {
        val faces = "3 0 1 2 255 0 0\n3 0 2 3 0 0.5 0 0.5\n3 0 1 3\n4 0 1 2 3 1 0 0 # red?\n"
        val codes = mesh("OFF\n4 4 0\n$square$faces").codes()
        assertEquals(listOf("FFFF0000", "80008000", "FFFFFFFF", "FFFF0000", "FFFF0000"), codes.map { it.single() })

        // Among whole numbers 1 is nearly nothing, and alone it is all
        assertEquals(listOf("FF010000", "FF00FF00"), twoFaces("1 0 0", "0 255 0"))
        assertEquals(listOf("FFFF0000", "FF0000FF"), twoFaces("1 0 0", "0 0 1 1"))
    }

    private fun twoFaces(first: String, second: String) =
        mesh("OFF\n4 2 0\n${square}3 0 1 2 $first\n3 0 2 3 $second\n").codes().map { it.single() }

    @Test
    fun verticesWithoutFacesArePoints() {
        val source = TestSources.of("COFF\n2 0 0\n0 0 0 255 0 0\n1 2 3 0 0 255\n")
        val points = OffParser.parse(source).surfaces.single() as Points
        assertEquals(listOf(0f, 0f, 0f, 1f, 2f, 3f), points.positions.toList())
        assertEquals(listOf(1f, 0f, 0f, 1f, 0f, 0f, 1f, 1f), points.colors?.toList())
        assertEquals(emptyList<String>(), source.warnings)
        val empty = TestSources.of("OFF\n0 0 0\n")
        assertEquals(0, OffParser.parse(empty).surfaces.size)
        assertTrue("there are no vertices" in empty.warnings.single())
    }

    private fun undeclared(first: String, second: String, third: String, header: String = "OFF") =
        mesh("$header\n3 1 0\n0 0 0 $first\n1 0 0 $second\n0 1 0 $third\n3 0 1 2\n", warnings = 1)

    @Test
    fun coloursThatTheHeaderDoesNotDeclareAreRead() {
        val expected = listOf(listOf("FFFF0000", "FF00FF00", "FF0000FF"))
        assertEquals(expected, undeclared("255 0 0", "0 255 0", "0 0 255").codes())
        assertEquals(expected, undeclared("1.0 0.0 0.0", "0.0 1.0 0.0", "0.0 0.0 1.0").codes())
        val alpha = undeclared("255 0 0 255", "0 255 0 128", "0 0 255 0")
        assertEquals(listOf(listOf("FFFF0000", "8000FF00", "000000FF")), alpha.codes())
    }

    @Test
    fun whatCouldBeSomethingElseIsNoColour() {
        assertNull(undeclared("0 0 1", "0 0 1", "0 0 1").colors)
        assertNull(undeclared("0.6 0.8 0", "0.8 0.6 0", "0 0.6 0.8").colors)
        assertNull(undeclared("255 0 0", "0 255 0", "").colors)
        assertNull(undeclared("255 0 0", "0 256 0", "0 0 255").colors)
        assertNull(undeclared("255 0 0", "0 255 0", "0 0 0.5").colors)
        assertNull(undeclared("-1 0 0", "0 1 0", "0 0 1").colors)
        assertNull(undeclared("0 0 1 255 0 0", "0 0 1 0 255 0", "0 0 1 0 0 255", "NOFF").colors)
    }

    @Test
    fun mistakesNameTheirLine() {
        fun assertFails(text: String, location: String?, part: String) {
            val error = TestSources.error(OffParser, TestSources.of(text))
            assertEquals(location, error.location, error.message)
            assertTrue(part in error.message!!, error.message)
        }
        assertFails("# nothing", null, "no words")
        assertFails("4OFF\n1 1 1\n", "line 1", "three dimensions")
        assertFails("STCN4nOFF\n5\n1 1 1\n", "line 1", "three dimensions")
        assertFails("OFF BINARY\n\u0000\u0000", "line 1", "binary OFF")
        assertFails("OFF\n4\n$square", "line 2", "numbers of vertices and faces")
        assertFails("OFF\n", "line 1", "numbers of vertices and faces")
        assertFails("OFF\n353535235358 6 0\n$square", "line 2", "353535235358")
        assertFails("OFF\n2000000000 6 0\n$square", "line 2", "too few")
        assertFails("OFF\n4 1 0\n0 0 0\n1 0\n0 1 0\n0 0 0\n3 0 1 2\n", "line 4", "has 2 numbers, not 3")
        assertFails("OFF\n4 1 0\n${square}3 0 1 4\n", "line 7", "0..3: 4")
        assertFails("OFF\n4 1 0\n${square}3 0 1 1.5\n", "line 7", "1.5")
        assertFails("OFF\n4 1 0\n${square}3 0 1\n", "line 7", "within a face of 3 corners")
        assertFails("OFF\n4 1 0\n${square}3 0 1 x\n", "line 7", "\"x\"")
        assertFails("OFF\n4 1 0\n0,5 0 0\n${square}3 0 1 x\n", "line 3", "decimal point")
        assertFails("OFF\n4 2 0\n${square}3 0 1 2\n", "line 7", "after 1 of 2 faces")
    }
}
