package dev.lazyz.setup

import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.Raster

/** From clip space to the raster's grid: the one place where a vertex is rounded (contract rules 1.3 and 4.2). */
internal class Viewport(val raster: Raster) {
    /** The guard band around this raster: 2^19 pixels from its origin, as a multiple of w. */
    val guardX: Double = 2.0 * ScreenGrid.GUARD / raster.width - 1.0

    /** See [guardX]. */
    val guardY: Double = 2.0 * ScreenGrid.GUARD / raster.height - 1.0

    /** Returns the column position of a vertex on the 1/256 pixel grid. */
    fun gridX(vertices: Vertices, vertex: Int): Int {
        val ndcX = vertices.get(vertex, Vertices.X) / vertices.get(vertex, Vertices.W)
        return ScreenGrid.snap((ndcX + 1.0) * 0.5 * raster.width)
    }

    /** Returns the row position of a vertex on the 1/256 pixel grid. */
    fun gridY(vertices: Vertices, vertex: Int): Int {
        val ndcY = vertices.get(vertex, Vertices.Y) / vertices.get(vertex, Vertices.W)
        return ScreenGrid.snap((1.0 - ndcY) * 0.5 * raster.height)
    }

    /** Returns the depth of a vertex. */
    fun depth(vertices: Vertices, vertex: Int): Int {
        val ndcZ = vertices.get(vertex, Vertices.Z) / vertices.get(vertex, Vertices.W)
        return depthOfUnit((ndcZ + 1.0) * 0.5)
    }

    /** Returns the depth at [unit] of the way from near to far, in the raster's convention. */
    fun depthOfUnit(unit: Double): Int {
        val depth = Depth.ofUnit(unit)
        return if (raster.convention == DepthConvention.SMALLER_IS_NEARER) depth else Int.MAX_VALUE - depth
    }
}
