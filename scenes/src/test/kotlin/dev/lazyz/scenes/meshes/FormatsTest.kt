package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.off.OffParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.stl.StlParser
import dev.lazyz.scenes.threemf.ThreeMfFiles
import dev.lazyz.scenes.threemf.ThreeMfParser
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** What the parsers of all formats of meshes have in common. */
class FormatsTest {
    /** A triangle of these corners in each format. */
    private fun files(corners: List<String>): Map<SceneParser, ByteArray> {
        val facet = "facet normal 0 0 1\nouter loop\n${corners.joinToString("") { "vertex $it\n" }}endloop\nendfacet\n"
        val ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n" +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        val lines = corners.joinToString("") { "$it\n" }
        return mapOf(
            ObjParser to corners.joinToString("") { "v $it\n" } + "f 1 2 3\n",
            StlParser to "solid far\n${facet}endsolid far\n",
            PlyParser to "$ply${lines}3 0 1 2\n",
            OffParser to "OFF\n3 1 0\n${lines}3 0 1 2\n",
        ).mapValues { it.value.toByteArray() } + (ThreeMfParser to threeMf(corners))
    }

    private fun threeMf(corners: List<String>): ByteArray {
        val vertices = corners.map { it.split(' ') }.joinToString("") { (x, y, z) ->
            "<vertex x=\"$x\" y=\"$y\" z=\"$z\"/>"
        }
        val triangles = "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
        val mesh = "<mesh><vertices>$vertices</vertices><triangles>$triangles</triangles></mesh>"
        val item = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/>"
        return ThreeMfFiles.of(ThreeMfFiles.model("<object id=\"1\">$mesh</object>", item))
    }

    @Test
    fun farFromTheOriginNoDetailIsLost() {
        val far = listOf("500123.001 4649776.002 3.125", "500124.001 4649776.002 3", "500124.001 4649777.503 3")
        val expected = far.flatMap { it.split(' ') }.map { it.toDouble() }
        for ((parser, bytes) in files(far)) {
            val mesh = parser.parse(TestSources.of(bytes)).meshes.single()
            for ((i, number) in expected.withIndex()) {
                val at = 3 * mesh.triangles[i / 3] + i % 3
                assertEquals(number, mesh.positions[at] + mesh.origin.get(i % 3), 1e-6, "$parser")
            }
        }
        for ((parser, bytes) in files(listOf("10 0 0", "11 0 0", "11 1 0"))) {
            assertEquals(Vector3d(), parser.parse(TestSources.of(bytes)).meshes.single().origin, "$parser")
        }
    }

    @Test
    fun notANumberIsKept() {
        for ((parser, bytes) in files(listOf("nan 0 0", "1 0 0", "1 1 0"))) {
            if (parser == ThreeMfParser) continue
            val mesh = parser.parse(TestSources.of(bytes)).meshes.single()
            assertEquals(1, mesh.triangleCount, "$parser")
            assertEquals(1, mesh.positions.count { it.isNaN() }, "$parser")
        }
    }
}
