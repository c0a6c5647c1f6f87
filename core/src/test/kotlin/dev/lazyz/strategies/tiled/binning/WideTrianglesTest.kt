package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Rgba
import dev.lazyz.setup.triangleBatch
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/**
 * How far triangles that reach many tiles hide each other: never what is visible, and always what is two units behind.
 */
class WideTrianglesTest {
    private val camera =
        Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)

    private fun frame(test: DepthTest, positions: FloatArray): Frame {
        val background = if (test.isGreatest()) 0 else Int.MAX_VALUE
        val raster = Raster(SIDE, SIDE, depthTest = test, backgroundDepth = background)
        val mesh = Mesh(positions, IntArray(positions.size / 3) { it }, Material(Rgba(1f, 0.5f, 0f)))
        return Scene(listOf(mesh), listOf(Light.Ambient(Rgba.WHITE)), camera).frame(raster)
    }

    /** Walls over the whole raster, each [units] of depth behind a wall in the middle of the range. */
    private fun walls(test: DepthTest, vararg units: Int): Frame {
        val direction = if (test.isGreatest()) 1 else -1
        val positions = FloatArray(9 * units.size) { i ->
            if (i % 3 == 2) (direction * (units[i / 9] + 0.25) * UNIT).toFloat() else WALL[i % 9]
        }
        val frame = frame(test, positions)
        val depths = List(units.size) { depth(frame, it, 0) }
        for (i in units.indices) {
            // Depths of distant walls are only approximate
            val expected = depths[0] - direction * (units[i] - units[0])
            if (units[i] <= FAR) assertEquals(expected, depths[i])
        }
        return frame
    }

    private fun depth(frame: Frame, triangle: Int, corner: Int): Int {
        val batch = frame.content.triangleBatch(0)
        return batch.grid[batch.place(triangle, corner) + 2]
    }

    private fun DepthTest.isGreatest() = this == DepthTest.GREATER || this == DepthTest.GREATER_OR_EQUAL

    private fun DepthTest.isLastFirst() = this == DepthTest.LESS_OR_EQUAL || this == DepthTest.GREATER_OR_EQUAL

    /** Number of entries in tiles, summed over all walls. */
    private fun entries(frame: Frame, tileSize: Int): Int {
        val test = frame.raster.depthTest
        val grid = TileGrid(frame.region, tileSize)
        val area = BinArea(grid, 0, grid.bands)
        val ends = BinBounds(1, area.tiles)
        val forms = TriangleForms(test)
        val triangles = NearToFar()
        val batch = frame.content.triangleBatch(0)
        for (i in 0 until batch.count) triangles.add(forms.nearest(batch, i))
        triangles.sort()
        WideTriangles(frame.content, area, grid, test, ArrayPool(), ends).enter(triangles, 0, 1, Checkpoint.NONE)
        return ends.sumUp()
    }

    @ParameterizedTest
    @EnumSource
    fun rule_5_1_aSurfaceAUnitInFrontOfALargeOneIsSeen(test: DepthTest) {
        for (gap in listOf(0, 1, 2, 3, 4, 5, 100, FAR)) {
            // The last wall is so far behind that the others count as equally near, and keep their order
            val frame = walls(test, gap, 0, 1 shl 29)
            val expected = ZBufferRenderer().render(frame)
            if (gap > 0) assertTrue(expected.primitive.all { it == 1 })
            for (tileSize in listOf(4, 16)) {
                val image = TiledRenderer(Coherence.DIRECT, 1, tileSize).render(frame)
                assertEquals(expected, image) { "gap $gap, tileSize $tileSize" }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    fun allThatIsTwoUnitsBehindALargeOneIsLeftOut(test: DepthTest) {
        for (tileSize in listOf(4, 16)) {
            val tiles = (SIDE / tileSize) * (SIDE / tileSize)
            for (gap in 0..5) {
                // One unit on both sides is allowed for rounding; at the limit, the order of submission decides
                val isHidden = gap > 2 || (gap == 2 && !test.isLastFirst())
                assertEquals(if (isHidden) tiles else 2 * tiles, entries(walls(test, 0, gap), tileSize)) { "gap $gap" }
            }
            assertEquals(tiles, entries(walls(test, 0, 3, 6, 9, 1000, FAR), tileSize))
        }
    }

    private companion object {
        const val SIDE = 32

        /** Many units, but few compared with the whole range. */
        const val FAR = 1 shl 19

        /** A unit of depth in world space: 8 from the near to the far plane, and 2^24 units outside each of them. */
        const val UNIT = 8.0 / ((1L shl 31) - 1 - (1L shl 25))

        /** Three vertices around the picture. */
        val WALL = floatArrayOf(-9f, -9f, 0f, 9f, -9f, 0f, 0f, 18f, 0f)
    }
}
