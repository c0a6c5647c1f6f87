package dev.lazyz.drawing

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Solids with known edges; meshes with defects. */
class FeatureEdgesTest {
    private val camera = Camera.perspective(
        Vector3d(3.0, 4.0, 9.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 30.0, 1.0, 100.0,
    )

    private fun count(mesh: Mesh, angle: Double = 30.0) = FeatureEdges(angle).of(mesh).segmentCount

    private fun mesh(vararg corners: Float) = Mesh(corners, IntArray(corners.size / 3) { it })

    @Test
    fun rule_10_1_aCubeHasTwelveCreases() {
        assertEquals(12, count(Solids.cube()))
        assertEquals(12, count(Solids.split(Solids.cube())), "vertices are joined by position")
        assertEquals(12, count(Solids.cube(), 89.0))
        assertEquals(0, count(Solids.cube(), 91.0))
        assertEquals(12, FeatureEdges().of(Solids.cube(), camera).segmentCount, "silhouettes are creases, too")
        assertEquals(6, FeatureEdges(180.0).of(Solids.cube(), camera).segmentCount, "only silhouettes")
    }

    @Test
    fun rule_10_1_theSilhouetteOfASphereIsOneClosedLoop() {
        val lines = FeatureEdges().of(Solids.split(Solids.sphere(40, 20)), camera)
        assertOneLoop(lines)
        assertEquals(0, count(Solids.sphere(40, 20)))
    }

    private fun assertOneLoop(lines: Lines) {
        val neighbours = HashMap<Int, MutableList<Int>>()
        for (i in lines.segments.indices step 2) {
            neighbours.getOrPut(lines.segments[i]) { ArrayList() } += lines.segments[i + 1]
            neighbours.getOrPut(lines.segments[i + 1]) { ArrayList() } += lines.segments[i]
        }
        assertEquals(setOf(2), neighbours.values.map { it.size }.toSet())
        val reached = HashSet<Int>()
        val next = ArrayDeque(listOf(neighbours.keys.first()))
        while (next.isNotEmpty()) {
            val point = next.removeFirst()
            if (reached.add(point)) next += neighbours.getValue(point)
        }
        assertEquals(neighbours.keys, reached)
    }

    @Test
    fun rule_10_1_anOpenSquareHasFourBoundaries() {
        val square = Mesh(floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f), intArrayOf(0, 1, 2, 0, 2, 3))
        assertEquals(4, count(square))
        assertEquals(4, FeatureEdges().of(square, camera).segmentCount)

        // A triangle with the opposite order of vertices makes no crease and no silhouette
        val twisted = Mesh(square.positions, intArrayOf(0, 1, 2, 0, 3, 2))
        assertEquals(4, FeatureEdges().of(twisted, camera).segmentCount)
    }

    /** Normals of equal length and direction: the cosine is exactly that of the limit. */
    @Test
    fun rule_10_1_anAngleOfExactlyTheLimitIsNoCrease() {
        val square = Mesh(floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f), intArrayOf(0, 1, 2, 0, 2, 3))
        assertEquals(4, count(square, 0.0))
        val bent = Mesh(square.positions.copyOf().also { it[11] = 1e-3f }, square.triangles)
        assertEquals(5, count(bent, 0.0))
        assertEquals(4, count(bent, 0.1))
    }

    @Test
    fun rule_10_1_anEdgeOfThreeTrianglesIsACrease() {
        val fan = Mesh(
            floatArrayOf(0f, 0f, 0f, 0f, 1f, 0f, 1f, 0f, 0f, -1f, 0f, 0.01f, -1f, 0f, -0.01f),
            intArrayOf(0, 1, 2, 0, 1, 3, 0, 1, 4),
        )
        assertEquals(7, count(fan))
    }

    @Test
    fun rule_10_1_defectsAreNoEdges() {
        val cube = Solids.cube()
        val doubled = Mesh(cube.positions, cube.triangles + cube.triangles.reversed().toIntArray())
        assertEquals(12, count(doubled), "duplicate triangles count once")
        val more = Mesh(
            cube.positions + floatArrayOf(Float.NaN, 0f, 0f, Float.POSITIVE_INFINITY, 1f, 1f),
            cube.triangles + intArrayOf(0, 0, 1, 2, 2, 2, 0, 1, 8, 3, 9, 1),
        )
        assertEquals(12, count(more), "triangles without area or with a NaN are ignored")
        assertEquals(0, count(mesh()))
        assertEquals(3, count(mesh(0f, 0f, 0f, 1f, 0f, 0f, 2f, 0f, 0f)), "a triangle in one line has boundaries")
        assertThrows(IllegalArgumentException::class.java) { FeatureEdges(181.0) }
        assertThrows(IllegalArgumentException::class.java) { FeatureEdges(Double.NaN) }
    }
}
