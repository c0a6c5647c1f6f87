package dev.lazyz.strategies.tiled.raster

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.samples
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.triangleBatch
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/** The edge functions and depths of a batch's triangles are those of its primitives, with any first sample. */
class TriangleFormsTest {
    /**
     * Triangles with vertices on samples, so that samples lie on edges, including horizontal ones; some with arbitrary
     * vertices, and some too steep for a linear form.
     */
    private fun frame(test: DepthTest): Frame {
        val random = Random(1988)
        val positions = FloatArray(9 * 200) { i ->
            val sample = random.nextInt(SIDE + 6) - 3 + if (i / 9 % 4 == 0) random.nextFloat() else 0.5f
            if (i % 3 == 2) random.nextFloat() * 6 - 3 else 2 * sample / SIDE - 1
        }
        for (triangle in 0 until 200 step 8) {
            val x = 2f * random.nextInt(SIDE) / SIDE - 1
            floatArrayOf(x, -0.7f, 3f, x + 4f / SIDE, 0.1f, -3f, x, 0.6f, 3f).copyInto(positions, 9 * triangle)
        }
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)
        val mesh = Mesh(positions, IntArray(positions.size / 3) { it }, Material())
        val raster = Raster(SIDE, SIDE, depthTest = test, backgroundDepth = Depth.FAR)
        return Scene(listOf(mesh), emptyList(), camera).frame(raster)
    }

    @ParameterizedTest
    @EnumSource
    fun rule_2_2_noEdgeFunctionIsNegativeWhereASampleIsCovered(test: DepthTest) {
        val frame = frame(test)
        val batch = frame.content.triangleBatch(0)
        val forms = TriangleForms(test)
        for (triangle in 0 until batch.count) {
            val covered = frame.primitives[triangle].samples(frame.raster)
            val (a, b, c) = List(3) { batch.place(triangle, it) }
            val xy = batch.grid
            for ((left, top) in listOf(0 to 0, 5 to 3)) {
                forms.edges(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[c], xy[c + 1], left, top)
                for (y in top until SIDE) {
                    for (x in left until SIDE) {
                        val e0 = forms.e0 + forms.e0dx * (x - left) + forms.e0dy * (y - top)
                        val e1 = forms.e1 + forms.e1dx * (x - left) + forms.e1dy * (y - top)
                        val e2 = forms.e2 + forms.e2dx * (x - left) + forms.e2dy * (y - top)
                        assertEquals(covered[x, y], e0 >= 0 && e1 >= 0 && e2 >= 0) { "$triangle: $x, $y" }
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    fun rule_3_3_keysHoldTheDepthsOfThePrimitives(test: DepthTest) {
        val frame = frame(test)
        val batch = frame.content.triangleBatch(0)
        val forms = TriangleForms(test)
        val same = TriangleForms(test)
        var samples = 0
        for (triangle in 0 until batch.count) {
            val primitive = frame.primitives[triangle] as? PlanarPrimitive ?: continue
            val covered = primitive.samples(frame.raster)
            for ((left, top) in listOf(0 to 0, 5 to 3)) {
                forms.depth(batch, triangle)
                same.depth(triangle, primitive.depthForm, primitive.leastDepth, primitive.greatestDepth)
                for (some in listOf(forms, same)) some.moveTo(left, top)
                for (y in top until SIDE) {
                    for (x in left until SIDE) {
                        if (!covered[x, y]) continue
                        samples++
                        val key = test.key(primitive.depth(x, y), triangle)
                        assertEquals(key, forms.keyAt(x - left, y - top))
                        assertEquals(key, same.keyAt(x - left, y - top))
                        assertTrue(key >= forms.nearest && key >= same.nearest)
                    }
                }
            }
        }
        assertTrue(samples > 5000) { "$samples" }
    }

    private companion object {
        const val SIDE = 16
    }
}
