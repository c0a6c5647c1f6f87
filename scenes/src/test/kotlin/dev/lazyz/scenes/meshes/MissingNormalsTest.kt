package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.off.OffParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

/** Normals that are zero or no numbers are those of a file without normals, corner by corner. */
class MissingNormalsTest {
    /** A low tent, whose ridge is smooth. */
    private val positions = listOf("0 0 0", "2 0 0", "2 1 0.3", "0 1 0.3", "2 2 0", "0 2 0")
    private val faces = listOf(listOf(0, 1, 2), listOf(0, 2, 3), listOf(3, 2, 4), listOf(3, 4, 5))
    private val given = "0.6 0 0.8"
    private val nothing = listOf("0 0 0", "nan nan nan", "0 -0 0", "inf 0 1", "0 nan 1")

    /** Normals of which those of the vertices [missing] have no direction. */
    private fun normals(missing: Set<Int>) =
        positions.indices.map { if (it in missing) nothing[it % nothing.size] else given }

    private fun obj(normals: List<String>?, before: String = "") = before +
        positions.joinToString("") { "v $it\n" } + normals.orEmpty().joinToString("") { "vn $it\n" } +
        faces.joinToString("") { face ->
            "f " + face.joinToString(" ") { if (normals == null) "${it + 1}" else "${it + 1}//${it + 1}" } + "\n"
        }

    private fun ply(normals: List<String>?): String {
        val names = listOf("x", "y", "z") + if (normals == null) emptyList() else listOf("nx", "ny", "nz")
        return "ply\nformat ascii 1.0\nelement vertex 6\n" + names.joinToString("") { "property float $it\n" } +
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + rows(normals) +
            faces.joinToString("") { "3 ${it.joinToString(" ")}\n" }
    }

    private fun off(normals: List<String>?) = (if (normals == null) "OFF" else "NOFF") + "\n6 4 0\n" + rows(normals) +
        faces.joinToString("") { "3 ${it.joinToString(" ")}\n" }

    private fun rows(normals: List<String>?) =
        positions.indices.joinToString("") { "${positions[it]} ${normals?.get(it).orEmpty()}\n" }

    private fun numbers(rows: List<String>) = rows.flatMap { row ->
        row.split(' ').map { if (it == "inf") Float.POSITIVE_INFINITY else it.replace("nan", "NaN").toFloat() }
    }

    private fun gltf(normals: List<String>?): String {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, numbers(positions))
        files.accessor("SCALAR", USHORT, faces.flatten())
        if (normals != null) files.accessor("VEC3", FLOAT, numbers(normals))
        val normal = if (normals == null) "" else ",\"NORMAL\":2"
        return files.json("""$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0$normal},"indices":1}]}]""")
    }

    private val files: Map<SceneParser, (List<String>?) -> String> =
        mapOf(ObjParser to { obj(it) }, PlyParser to ::ply, OffParser to ::off, GltfParser to ::gltf)

    private fun mesh(parser: SceneParser, text: String): Mesh = parser.parse(TestSources.of(text)).meshes.single()

    private fun Mesh.cornerNormals(): List<List<Float>> =
        triangles.map { checkNotNull(normals).slice(3 * it until 3 * it + 3).map { number -> number + 0f } }

    @Test
    fun missingNormalsAreThoseOfAFileWithoutNormals() {
        for ((parser, file) in files) {
            val without = mesh(parser, file(null))

            // glTF demands flat triangles
            val computed = if (without.normals == null) without.withSmoothNormals(0.0) else without
            for (missing in listOf(setOf(2), setOf(0, 3, 5), setOf(0, 1, 2, 3, 4))) {
                val mesh = mesh(parser, file(normals(missing)))
                assertEquals(without.corners(), mesh.corners())
                for ((corner, vertex) in faces.flatten().withIndex()) {
                    val expected = if (vertex in missing) computed.cornerNormals()[corner] else numbers(listOf(given))
                    assertEquals(expected, mesh.cornerNormals()[corner], "$parser: corner $corner of $missing")
                }
            }
        }
    }

    @Test
    fun facesOfAnObjThatAreNotSmoothGetTheirOwn() {
        val flat = mesh(ObjParser, obj(null)).withSmoothNormals(0.0)
        val mesh = mesh(ObjParser, obj(normals(setOf(0, 2)), "s off\n"))
        assertEquals(flat.cornerNormals()[2], mesh.cornerNormals()[2])
        assertEquals(flat.cornerNormals()[6], mesh(ObjParser, obj(normals(setOf(2, 3)), "s 0\n")).cornerNormals()[6])
        assertNull(mesh(ObjParser, obj(normals(positions.indices.toSet()), "s off\n")).normals)
        val source =
            Source(obj(normals(setOf(2))).toByteArray(), "test", null, Loading(LoadOptions(smoothNormals = false)))
        assertEquals(flat.cornerNormals()[2], ObjParser.parse(source).meshes.single().cornerNormals()[2])
    }

    @Test
    fun pointsWithoutADirectionAreNotLitFromNowhere() {
        val cloud = ply(normals(setOf(0, 1, 2))).replace("element face 4\nproperty list uchar int vertex_indices\n", "")
            .lines().dropLast(5).joinToString("\n")
        val points = PlyParser.parse(TestSources.of("$cloud\n")).surfaces.single() as Points
        assertEquals(List(9) { 0f } + List(3) { listOf(0.6f, 0f, 0.8f) }.flatten(), points.normals!!.toList())
        val dark = cloud.replace(given, "0 0 0")
        assertNull((PlyParser.parse(TestSources.of("$dark\n")).surfaces.single() as Points).normals)
        val gltf = gltf(List(6) { "0 0 0" }).replace("\"indices\":1", "\"indices\":1,\"mode\":0")
        assertNull((GltfParser.parse(TestSources.of(gltf)).surfaces.single() as Points).normals)
    }
}
