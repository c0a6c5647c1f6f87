package dev.lazyz.world.surface

import dev.lazyz.SampleScenes
import dev.lazyz.drawing.Solids
import dev.lazyz.geometry.Box
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Polygon.Vertex
import java.util.Random
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class MeshTest {
    private fun point(array: FloatArray, i: Int) =
        Vector3d(array[3 * i].toDouble(), array[3 * i + 1].toDouble(), array[3 * i + 2].toDouble())

    private fun faceNormal(mesh: Mesh, triangle: Int): Vector3d {
        val (a, b, c) = List(3) { point(mesh.positions, mesh.triangles[3 * triangle + it]) }
        return b.sub(a).cross(c.sub(a)).normalize()
    }

    @Test
    fun smoothNormalsKeepAttributes() {
        val random = Random(2)
        val mesh = SampleScenes.soup(random, 5, Material())
        val smooth = mesh.withSmoothNormals()
        for (corner in mesh.triangles.indices) {
            val from = mesh.triangles[corner]
            val to = smooth.triangles[corner]
            for (k in 0 until 2) assertEquals(mesh.uvs!![2 * from + k], smooth.uvs!![2 * to + k])
            for (k in 0 until 4) assertEquals(mesh.colors!![4 * from + k], smooth.colors!![4 * to + k])
        }
        assertThrows(IllegalArgumentException::class.java) { mesh.withSmoothNormals(-1.0) }
        assertThrows(IllegalArgumentException::class.java) { mesh.withSmoothNormals(Double.NaN) }
    }

    @Test
    fun transformsMoveNormalsWithTheirFaces() {
        val random = Random(3)
        repeat(100) {
            val matrix = Matrix4d()
            for (column in 0 until 4) for (row in 0 until 3) matrix.set(column, row, random.nextDouble() * 4 - 2)
            if (Math.abs(matrix.determinant()) < 0.1) return@repeat
            val moved = Solids.cube().withSmoothNormals().transformed(matrix)
            for (i in 0 until 12) {
                val face = faceNormal(moved, i)
                for (k in 0 until 3) {
                    val normal = point(moved.normals!!, moved.triangles[3 * i + k])
                    assertEquals(0.0, face.distance(normal), 1e-4) { "$matrix" }
                }
                val center = matrix.transformPosition(Vector3d())
                val corner = point(moved.positions, moved.triangles[3 * i])
                assertTrue(face.dot(corner.sub(center)) > 0) { "outside is not outside after $matrix" }
            }
        }
    }

    /** The lengths of normals are weights between vertices. */
    @Test
    fun theIdentityKeepsThePictureAndTranslationsTheNormals() {
        val normals = floatArrayOf(0f, 0f, 9f, 0.3f, 0.1f, 0.2f, -0.4f, 0.5f, 0.7f)
        val tangents = floatArrayOf(3f, 0f, 0f, 1f, 0.1f, 0f, 0f, -1f, 0f, 2f, 0f, 1f)
        val mesh = Mesh(
            floatArrayOf(0f, 0f, 0f, 1f, 0.1f, 0f, 0.2f, 1f, 0.5f), intArrayOf(0, 1, 2),
            Material(shading = Shading.PHONG), normals, tangents = tangents,
        )
        fun picture(mesh: Mesh) = ZBufferRenderer().render(Scene(listOf(mesh)).frame(40, 40)).argb
        assertArrayEquals(picture(mesh), picture(mesh.transformed(Matrix4d())))
        val moved = mesh.transformed(Matrix4d().translation(1.0, 2.0, 3.0))
        assertArrayEquals(normals, moved.normals)
        assertArrayEquals(tangents, moved.tangents)
        val scaled = mesh.transformed(Matrix4d().scaling(2.0))
        assertFalse(picture(mesh).contentEquals(picture(scaled)))
        for (vertex in 0 until 3) assertEquals(1.0, point(scaled.normals!!, vertex).length(), 1e-6)
        val cloud = Points(mesh.positions, normals = normals)
        assertArrayEquals(normals, cloud.transformed(Matrix4d()).normals)
    }

    @Test
    fun wrongArraysAreRefused() {
        val p = FloatArray(9)
        val t = intArrayOf(0, 1, 2)
        fun refused(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block)
        refused { Mesh(FloatArray(8), t) }
        refused { Mesh(p, intArrayOf(0, 1)) }
        refused { Mesh(p, intArrayOf(0, 1, 3)) }
        refused { Mesh(p, intArrayOf(0, -1, 2)) }
        refused { Mesh(p, t, normals = FloatArray(8)) }
        refused { Mesh(p, t, uvs = FloatArray(9)) }
        refused { Mesh(p, t, colors = FloatArray(9)) }
        Mesh(FloatArray(0), IntArray(0))
    }

    @Test
    fun spheresScaleAlikeOnly() {
        val sphere = Sphere(Vector3d(1.0, 2.0, 3.0), 2.0)
        val matrix = Matrix4d().translate(1.0, 0.0, 0.0).rotateY(0.3).scale(-3.0)
        val moved = sphere.transformed(matrix)
        assertEquals(6.0, moved.radius, 1e-12)
        val center = matrix.transformPosition(Vector3d(1.0, 2.0, 3.0))
        assertEquals(0.0, center.distance(moved.center), 1e-12)
        assertThrows(IllegalArgumentException::class.java) { sphere.transformed(Matrix4d().scale(1.0, 1.0, 1.01)) }
        assertThrows(IllegalArgumentException::class.java) { Sphere(Vector3d(), -1.0) }
    }

    @Test
    fun boundsPassOverWhatIsNotFinite() {
        val positions = floatArrayOf(0f, 1f, 2f, Float.NaN, 9f, 9f, 3f, -1f, 5f, 9f, Float.POSITIVE_INFINITY, 9f)
        val mesh = Mesh(positions, intArrayOf(0, 1, 2, 3, 0, 1))
        assertEquals(Box(0.0, -1.0, 2.0, 3.0, 1.0, 5.0).toString(), mesh.bounds.toString())
        assertEquals(null, Mesh(FloatArray(0), IntArray(0)).bounds)
        assertEquals(null, Sphere(Vector3d(Double.NaN), 1.0).bounds)
        assertEquals(null, Polygon(emptyList()).bounds)
    }

    @Test
    fun boundsOfPolygonsAreAsPreciseAsTheirVertices() {
        val vertices = listOf(Vertex(1e8 + 0.25, 0.1, 1e-60), Vertex(1e8 + 2.75, 0.2, 0.0), Vertex(1e8, 0.3, 0.0))
        val box = Polygon(listOf(vertices)).bounds!!
        for (v in vertices) {
            val isInside = v.x in box.minX..box.maxX && v.y in box.minY..box.maxY && v.z in box.minZ..box.maxZ
            assertTrue(isInside) { "$v in $box" }
        }
    }
}
