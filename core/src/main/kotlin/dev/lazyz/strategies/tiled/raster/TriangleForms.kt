package dev.lazyz.strategies.tiled.raster

import dev.lazyz.DepthTest
import dev.lazyz.raster.Edge
import dev.lazyz.raster.EdgeForms
import dev.lazyz.raster.ReferenceTriangle
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.spi.LinearForm

/**
 * One triangle, prepared for drawing into an area of the raster: its edge functions and its depth, as linear forms with
 * the origin at the area's first sample. Reused for each triangle; belongs to one thread.
 *
 * A sample is covered if no edge function is negative. The functions of edges that own no samples, the right and lower
 * ones (contract rule 2.2), are lowered by one. All values are exact, see [ReferenceTriangle].
 *
 * Depth is inverted where the greatest depth wins, so that in every case the visible fragment has the least key. A key
 * consists of the form's upper 32 bits, followed by [rank].
 *
 * Source: Juan Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988.
 */
internal class TriangleForms(private val test: DepthTest) : EdgeForms() {
    private val isReversed = test.key(1, 0) < test.key(0, 0)

    /** Depth: value at the origin, and steps by column and row; inverted where the greatest depth wins. */
    @JvmField var z: Long = 0L

    @JvmField var zdx: Long = 0L

    @JvmField var zdy: Long = 0L

    /** Lower half of the keys. */
    @JvmField var rank: Long = 0L

    /** A lower bound of the triangle's keys. */
    @JvmField var nearest: Long = 0L

    /**
     * Sets the edge functions of the triangle with these vertices for an area whose first sample is ([column], [row]).
     */
    fun edges(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int, column: Int, row: Int) {
        // Make the triangle clockwise on the screen, so that all edge functions are positive inside
        if (Edge.function(ax, ay, bx, by, cx, cy) < 0) return edges(ax, ay, cx, cy, bx, by, column, row)
        val sampleX = column * ScreenGrid.STEPS + ScreenGrid.CENTER
        val sampleY = row * ScreenGrid.STEPS + ScreenGrid.CENTER
        e0dx = -STEPS * (by - ay)
        e0dy = STEPS * (bx - ax)
        e0 = edge(ax, ay, bx, by, sampleX, sampleY)
        e1dx = -STEPS * (cy - by)
        e1dy = STEPS * (cx - bx)
        e1 = edge(bx, by, cx, cy, sampleX, sampleY)
        e2dx = -STEPS * (ay - cy)
        e2dy = STEPS * (ax - cx)
        e2 = edge(cx, cy, ax, ay, sampleX, sampleY)
    }

    private fun edge(fromX: Int, fromY: Int, toX: Int, toY: Int, sampleX: Int, sampleY: Int): Long {
        val lowered = if (Edge.isTopLeft(toX - fromX, toY - fromY)) 0 else 1
        return Edge.function(fromX, fromY, toX, toY, sampleX, sampleY) - lowered
    }

    /**
     * Sets depth from the vertices' depths, in the order in which they were submitted; see [ReferenceTriangle.form].
     */
    private fun depth(index: Int, ax: Int, ay: Int, az: Int, bx: Int, by: Int, bz: Int, cx: Int, cy: Int, cz: Int) {
        rank(index, minOf(az, minOf(bz, cz)) - 1, maxOf(az, maxOf(bz, cz)) + 1)
        ReferenceTriangle.form(
            ax, ay, az, bx, by, bz, cx, cy, cz,
            steep = { form((az.toLong() shl 32) + LinearForm.HALF, 0, 0) },
        ) { origin, dx, dy -> form(origin, dx, dy) }
    }

    /** Sets the depth of triangle number [triangle] of [batch]. */
    fun depth(batch: TriangleBatch, triangle: Int) {
        val grid = batch.grid
        val a = batch.place(triangle, 0)
        val b = batch.place(triangle, 1)
        val c = batch.place(triangle, 2)
        depth(
            batch.first + triangle, grid[a], grid[a + 1], grid[a + 2], grid[b], grid[b + 1], grid[b + 2], grid[c],
            grid[c + 1], grid[c + 2],
        )
    }

    /** Sets depth from a form and its bounds. */
    fun depth(index: Int, form: LinearForm, least: Int, greatest: Int) {
        rank(index, least, greatest)
        form(form.c, form.dx, form.dy)
    }

    /** Returns a lower bound of the keys of triangle number [triangle] of [batch]. */
    fun nearest(batch: TriangleBatch, triangle: Int): Long = nearest(
        batch.first + triangle,
        batch.grid[batch.place(triangle, 0) + 2],
        batch.grid[batch.place(triangle, 1) + 2],
        batch.grid[batch.place(triangle, 2) + 2],
    )

    /** Returns an upper bound of the keys of triangle number [triangle] of [batch]. */
    fun farthest(batch: TriangleBatch, triangle: Int): Long {
        val az = batch.grid[batch.place(triangle, 0) + 2]
        val bz = batch.grid[batch.place(triangle, 1) + 2]
        val cz = batch.grid[batch.place(triangle, 2) + 2]
        val depth = if (isReversed) minOf(az, minOf(bz, cz)) else maxOf(az, maxOf(bz, cz))
        return test.key(depth, batch.first + triangle) + (1L shl Int.SIZE_BITS)
    }

    private fun nearest(index: Int, az: Int, bz: Int, cz: Int): Long =
        test.key(if (isReversed) maxOf(az, maxOf(bz, cz)) + 1 else minOf(az, minOf(bz, cz)) - 1, index)

    /** Returns the key at a sample, relative to the origin of depth: that of the raster, or see [moveTo]. */
    fun keyAt(x: Int, y: Int): Long = ((z + zdx * x + zdy * y) and DEPTH_BITS) or rank

    private fun rank(index: Int, least: Int, greatest: Int) {
        rank = test.key(0, index) and 0xFFFF_FFFFL
        nearest = test.key(if (isReversed) greatest else least, index)
    }

    /** The origin is that of the raster until [moveTo] is called. */
    private fun form(c: Long, dx: Long, dy: Long) {
        z = if (isReversed) Long.MAX_VALUE - c else c
        zdx = if (isReversed) -dx else dx
        zdy = if (isReversed) -dy else dy
    }

    /** Moves the origin of depth from the raster's to an area's first sample. */
    fun moveTo(column: Int, row: Int) {
        z += zdx * column + zdy * row
    }

    private companion object {
        const val STEPS = ScreenGrid.STEPS.toLong()

        /** The upper half of a key. */
        const val DEPTH_BITS = -1L shl Int.SIZE_BITS
    }
}
