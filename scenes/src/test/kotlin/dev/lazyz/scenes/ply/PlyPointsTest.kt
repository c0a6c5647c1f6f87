package dev.lazyz.scenes.ply

import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Files without faces: clouds of points, and edges. */
class PlyPointsTest {
    private val places = listOf("property float x", "property float y", "property float z")

    private fun header(vararg lines: String) =
        "ply\nformat FORMAT 1.0\n" + lines.joinToString("") { "$it\n" } + "end_header\n"

    private val edges = header(
        "element vertex 3", *places.toTypedArray(), "element edge 2", "property int vertex1", "property int vertex2",
    )

    private fun ascii(header: String, body: String) = TestSources.of(header.replace("FORMAT", "ascii") + body)

    @Test
    fun verticesAloneAreACloud() {
        val header = header(
            "element vertex 2", *places.toTypedArray(), "property float nx", "property float ny", "property float nz",
            "property uchar red", "property uchar green", "property uchar blue",
        )
        val rows = listOf(listOf(1, 2, 3, 0, 0, 1, 255, 0, 0), listOf(4, 5, 6, 1, 0, 0, 0, 255, 0))
        val types = List(6) { "float" } + List(3) { "uchar" }
        for (format in PlyFormat.entries) {
            val source = TestSources.of(PlyFiles.of(format, header, listOf(types.joinToString(" ") to rows)))
            val points = PlyParser.parse(source).surfaces.single() as Points
            assertArrayEquals(floatArrayOf(1f, 2f, 3f, 4f, 5f, 6f), points.positions, "$format")
            assertArrayEquals(floatArrayOf(0f, 0f, 1f, 1f, 0f, 0f), points.normals, "$format")
            assertArrayEquals(floatArrayOf(1f, 0f, 0f, 1f, 0f, 1f, 0f, 1f), points.colors, "$format")
            assertEquals(Rgba.WHITE, points.material.baseColor)
            assertEquals(emptyList<String>(), source.warnings)
        }
    }

    @Test
    fun splatsArePointsInTheColourOfTheirFirstCoefficient() {
        val names = listOf("nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "f_rest_0", "opacity", "scale_0", "rot_0")
        val header = header("element vertex 2", *(places + names.map { "property float $it" }).toTypedArray())
        val rows = listOf(
            listOf(1, 2, 3, 0, 0, 0, 0, 1.0, -1.0, 7, 9, -4, 1), listOf(4, 5, 6, 0, 0, 0, 9, -9, 0.5, 7, 9, -4, 1),
        )
        for (format in PlyFormat.entries) {
            val types = List(13) { "float" }.joinToString(" ")
            val source = TestSources.of(PlyFiles.of(format, header, listOf(types to rows)))
            val points = PlyParser.parse(source).surfaces.single() as Points
            val codes = List(2) { i -> points.colors!!.slice(4 * i until 4 * i + 4) }
                .map { (r, g, b, a) -> "%08X".format(Rgba(r, g, b, a).toArgb()) }
            assertEquals(listOf("FF80C738", "FFFF00A3"), codes, "$format")
            assertNull(points.normals)
            val unused = "test: properties that are not used: f_rest_0, opacity, scale_0, rot_0 of 2 vertex"
            assertEquals(listOf(unused), source.warnings)
        }
    }

    @Test
    fun edgesAreLines() {
        val tables = listOf(
            "float float float" to listOf(listOf(0, 0, 0), listOf(1, 0, 0), listOf(1, 1, 0)),
            "int int" to listOf(listOf(0, 1), listOf(2, 1)),
        )
        for (format in PlyFormat.entries) {
            val source = TestSources.of(PlyFiles.of(format, edges, tables))
            val lines = PlyParser.parse(source).surfaces.single() as Lines
            assertArrayEquals(intArrayOf(0, 1, 2, 1), lines.segments, "$format")
            assertEquals(9, lines.positions.size)
        }
    }

    @Test
    fun edgesFollowTheMesh() {
        val header = header(
            "element edge 1", "property int vertex1", "property int vertex2", "element vertex 3",
            *places.toTypedArray(), "element face 1", "property list uchar int vertex_indices",
        )
        val surfaces = PlyParser.parse(ascii(header, "0 2\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n")).surfaces
        assertTrue(surfaces[0] is Mesh && surfaces[1] is Lines)
    }

    @Test
    fun wrongEdgesAreRefused() {
        for (wrong in listOf("0 3", "-1 0", "0.5 1")) {
            val source = ascii(edges.replace("property int", "property float"), "0 0 0\n1 0 0\n1 1 0\n0 1\n$wrong\n")
            val message = TestSources.error(PlyParser, source).message!!
            assertTrue("vertex number" in message && "line 15" in message) { message }
        }
    }

    @Test
    fun aFileOfNothingGivesAWarning() {
        val source = ascii(header("element vertex 0", *places.toTypedArray()), "")
        assertEquals(0, PlyParser.parse(source).surfaces.size)
        assertEquals(1, source.warnings.size)
    }
}
