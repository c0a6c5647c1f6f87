package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.SampleScenes
import dev.lazyz.shading.Vertices
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The triangles of a batch are equal to the primitives that its mesh gives one by one. */
class TriangleBatchTest {
    private val flat = Camera.orthographic(Vector3d(0.3, 0.4, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 20.0)

    /** Tilted, and not looking at the origin: no element of its matrix is 0. */
    private val tilted =
        Camera.perspective(Vector3d(0.9, 0.7, 5.0), Vector3d(0.2, -0.1, 0.3), Vector3d(0.3, 1.0, 0.1), 40.0, 1.0, 20.0)

    /** Asserts this for a mesh. Returns how many of its triangles are drawn from the batch, clipped, and left out. */
    private fun assertSame(mesh: Mesh, camera: Camera): List<Int> {
        val frame = Scene(listOf(mesh), emptyList(), camera).frame(32, 24)
        val batch = frame.content.triangleBatch(0)
        val exceptions = batch.exceptions.associate { it.index to it.value }
        val counts = IntArray(3)
        for ((triangle, primitive) in frame.primitives.withIndex()) {
            if (!batch.isDrawn(triangle)) {
                counts[if (triangle in exceptions) 1 else 2]++
                // Clipped triangles are single primitives; the others cover nothing
                assertEquals(primitive !is EmptyPrimitive, triangle in exceptions)
                exceptions[triangle]?.let { assertEquals(primitive.toString(), it.toString()) }
                continue
            }
            counts[0]++
            assertTrue(triangle !in exceptions)
            if (primitive !is PlanarPrimitive) continue
            val t = primitive.reference
            val places = listOf(t.x0 to t.y0, t.x1 to t.y1, t.x2 to t.y2)
            for ((corner, place) in places.withIndex()) {
                val at = batch.place(triangle, corner)
                assertEquals(place, batch.grid[at] to batch.grid[at + 1])
                val w = primitive.vertices.get(primitive.corners[corner], Vertices.W)
                assertEquals(1.0 / w, batch.inverseW(batch.corners[3 * triangle + corner]))
            }
            val depths = List(3) { batch.grid[batch.place(triangle, it) + 2] }
            val form = t.form(depths[0], depths[1], depths[2])
            assertEquals(form.toString(), primitive.depthForm.toString())
        }
        assertEquals(counts[1], exceptions.size)
        return counts.toList()
    }

    @Test
    fun rule_9_1_trianglesAreDrawnCutOrLeftOut() {
        val random = Random(9)
        for (camera in listOf(SampleScenes.camera, flat, tilted)) {
            val sums = IntArray(3)
            for (sides in Sides.entries) {
                for (reach in listOf(1.0, 6.0, 30.0)) {
                    val mesh = SampleScenes.soup(random, 150, Material(sides = sides), reach)
                    // Some vertices are not finite
                    mesh.positions[random.nextInt(450)] = Float.NaN
                    mesh.positions[random.nextInt(450)] = Float.POSITIVE_INFINITY
                    assertSame(mesh, camera).forEachIndexed { i, count -> sums[i] += count }
                }
            }
            assertTrue(sums.all { it > 50 }) { "${sums.toList()}" }
        }
    }

    @Test
    fun largeMeshesAreSnappedInParts() {
        val random = Random(10)
        for (triangles in listOf(5461, 5462, 11_000)) {
            val mesh = SampleScenes.soup(random, triangles, Material(), 1.0)
            assertEquals(listOf(triangles, 0, 0), assertSame(mesh, SampleScenes.camera))
        }
    }

    @Test
    fun aMeshWithAllInsideHasNoExceptions() {
        for (camera in listOf(flat, tilted)) {
            val oneSided = SampleScenes.soup(Random(11), 64, Material(sides = Sides.FRONT), 0.5)
            assertEquals(0, assertSame(oneSided, camera)[1])
        }
        val mesh = SampleScenes.soup(Random(11), 64, Material(), 0.5)
        val frame = Scene(listOf(mesh, mesh), emptyList(), flat).frame(8, 8)
        val batches = frame.content.batches.indices.map(frame.content::triangleBatch)
        assertEquals(listOf(0, 64), batches.map { it.first })
        for (batch in batches) {
            assertSame(mesh, batch.mesh)
            assertTrue(batch.exceptions.isEmpty() && (0 until 64).all { batch.isDrawn(it) })
        }
    }
}
