package dev.lazyz.strategies.tiled.binning

import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import dev.lazyz.strategies.tiled.Kernels
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The coverage of many triangles at a time is that of one after the other, for any number of triangles. */
class SmallTriangleKernelTest {
    @Test
    fun kernelsGiveTheSameBits() {
        val batch = batch(Random(3))
        val kernel = Kernels.best().coverage()
        val plain = ScalarSmallTriangleKernel()
        val kinds = HashSet<Int>()
        // All numbers of triangles around those that fill one, two or more vectors, also not from the first on
        for (first in 0..1) {
            for (count in (1..70) + listOf(SmallTriangleKernel.COUNT - 1, SmallTriangleKernel.COUNT)) {
                var start = first
                while (start + count <= batch.count) {
                    kernel.cover(batch, start, count)
                    plain.cover(batch, start, count)
                    for (i in 0 until count) {
                        val what = "triangle ${start + i}, number $i of $count"
                        assertEquals(plain.left[i] to plain.top[i], kernel.left[i] to kernel.top[i]) { what }
                        assertEquals(plain.covered[i], kernel.covered[i]) { what }
                        kinds += plain.covered[i]
                    }
                    start += count
                }
            }
        }
        assertTrue(kinds.size > 30 && SmallTriangleKernel.LARGE in kinds && 0 in kinds) { "$kinds" }
    }

    /**
     * Small triangles with vertices on samples and anywhere; without area; far outside the picture; and as large as the
     * guard band.
     */
    private fun batch(random: Random): TriangleBatch {
        val positions = FloatArray(9 * 600)
        for (triangle in 0 until 600) {
            val isHuge = triangle % 11 == 0
            val origin = if (triangle % 7 == 0) FAR else 0f
            val x = origin * (random.nextInt(3) - 1) + random.nextInt(SIDE)
            val y = origin * (random.nextInt(3) - 1) + random.nextInt(SIDE)
            for (corner in 0 until 3) {
                val at = 9 * triangle + 3 * corner
                for ((axis, place) in listOf(x, y).withIndex()) {
                    val offset = when {
                        isHuge -> FAR * (random.nextFloat() * 2 - 1)
                        triangle % 2 == 0 -> 0.5f * random.nextInt(9)
                        else -> 4 * random.nextFloat()
                    }
                    positions[at + axis] = if (isHuge) offset else place + offset
                }
                if (triangle % 13 == 0 && corner == 2) positions.copyInto(positions, at, at - 3, at)
            }
        }
        // One unit a pixel
        val eye = Vector3d(SIDE / 2.0, SIDE / 2.0, 5.0)
        val target = Vector3d(SIDE / 2.0, SIDE / 2.0, 0.0)
        val camera = Camera.orthographic(eye, target, Vector3d(0.0, 1.0, 0.0), SIDE.toDouble(), 1.0, 9.0)
        val mesh = Mesh(positions, IntArray(positions.size / 3) { it }, Material())
        return Scene(listOf(mesh), emptyList(), camera).frame(SIDE, SIDE).content.triangleBatch(0).also {
            assertTrue((0 until it.count).all(it::isDrawn))
        }
    }

    private companion object {
        const val SIDE = 64

        /** Pixels; a little less than the guard band. */
        const val FAR = 520_000f
    }
}
