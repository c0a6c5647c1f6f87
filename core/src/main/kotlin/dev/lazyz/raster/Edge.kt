package dev.lazyz.raster

/**
 * An edge on the 1/256 pixel grid, from one vertex to the next (contract rules 2.2 and 3.6).
 *
 * Coordinates are within the guard band, so products are exact in 64 bits. [isTopLeft] is the top-left rule.
 *
 * Source: Juan Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988.
 */
internal object Edge {
    /**
     * Returns twice the signed area, square grid units, of the triangle of an edge and the point ([x], [y]): positive
     * if the point is on the right of the edge as it runs, that is if the three are clockwise on the
     * screen; 0 if it is on the line through the edge.
     */
    @JvmStatic
    fun function(fromX: Int, fromY: Int, toX: Int, toY: Int, x: Int, y: Int): Long =
        (toX - fromX).toLong() * (y - fromY) - (toY - fromY).toLong() * (x - fromX)

    /**
     * The top-left rule (rule 2.2): whether the samples on an edge belong to the shape on its right. They do if it is a
     * left edge, which runs upward, or a top edge, which runs to the right. [runX] and [runY] are the extents of the
     * edge, from its start to its end.
     */
    @JvmStatic
    fun isTopLeft(runX: Int, runY: Int): Boolean = runY < 0 || (runY == 0 && runX > 0)

    /**
     * Returns the position where an edge crosses row [row], as the numerator of a fraction in pixels with denominator
     * `256 * runY`, relative to the sample of column 0. The edge begins at its upper end, ([upperX], [upperY]), and
     * extends by [runX] and, downward, by [runY].
     */
    @JvmStatic
    fun crossing(upperX: Int, upperY: Int, runX: Int, runY: Int, row: Int): Long {
        val down = (row * ScreenGrid.STEPS + ScreenGrid.CENTER - upperY).toLong()
        return (upperX - ScreenGrid.CENTER).toLong() * runY + down * runX
    }
}
