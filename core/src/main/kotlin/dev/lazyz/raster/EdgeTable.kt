package dev.lazyz.raster

import dev.lazyz.HeapLayout
import dev.lazyz.bytes
import dev.lazyz.geometry.FillRule
import dev.lazyz.spi.Spans

/**
 * The edges of a polygon that cross rows of the raster, as exact integers (contract rule 2).
 *
 * Vertices are on the 1/256 pixel grid. An edge crosses row y if its upper end is at or above the samples of the row,
 * and its lower end is below them. The crossing covers the samples at it and to the right of it. So a sample exactly
 * on an edge is inside for left and top edges: the top-left rule.
 *
 * @param xs x of the vertices, grid units, one contour after the other
 * @param ys y of the vertices, grid units
 * @param contourEnds for each contour, the index after its last vertex
 * @param fillRule which samples are inside
 * @param width columns of the raster
 * @param height rows of the raster
 */
internal class EdgeTable(
    xs: IntArray,
    ys: IntArray,
    contourEnds: IntArray,
    val fillRule: FillRule,
    val width: Int,
    height: Int,
) {
    /** Fields of the edges, [STRIDE] numbers for each. */
    private val fields: IntArray

    /** Number of edges. */
    val count: Int

    /** First row that any edge crosses. */
    val rowStart: Int

    /** The row after the last row that any edge crosses; at most [rowStart] if there is none. */
    val rowEnd: Int

    init {
        val edges = IntArray(STRIDE * xs.size)
        var used = 0
        var top = height
        var bottom = 0
        var contourStart = 0
        for (contourEnd in contourEnds) {
            var previous = contourEnd - 1
            for (current in contourStart until contourEnd) {
                // Keep an edge if it crosses a row of samples; horizontal edges never do
                val isDown = ys[previous] < ys[current]
                val upper = if (isDown) previous else current
                val lower = if (isDown) current else previous
                val start = maxOf(ScreenGrid.firstSample(ys[upper]), 0)
                val end = minOf(ScreenGrid.firstSample(ys[lower]), height)
                if (start < end) {
                    val at = STRIDE * used++
                    edges[at + START] = start
                    edges[at + END] = end
                    edges[at + X] = xs[upper]
                    edges[at + Y] = ys[upper]
                    edges[at + DX] = xs[lower] - xs[upper]
                    edges[at + DY] = ys[lower] - ys[upper]
                    edges[at + WINDING] = if (isDown) 1 else -1
                    top = minOf(top, start)
                    bottom = maxOf(bottom, end)
                }
                previous = current
            }
            contourStart = contourEnd
        }
        fields = if (used == xs.size) edges else edges.copyOf(STRIDE * used)
        count = used
        rowStart = top
        rowEnd = bottom
    }

    /** Bytes of the table. */
    val heldBytes: Long get() = HeapLayout.EDGE_TABLE + fields.bytes

    /** First row that edge [edge] crosses. */
    fun start(edge: Int): Int = fields[STRIDE * edge + START]

    /** The row after the last row that edge [edge] crosses. */
    fun end(edge: Int): Int = fields[STRIDE * edge + END]

    /** +1 if the contour runs downward along [edge], -1 if it runs upward. */
    fun winding(edge: Int): Int = fields[STRIDE * edge + WINDING]

    /** Horizontal extent of [edge], grid units, from its upper end to its lower end; positive to the right. */
    fun dx(edge: Int): Long = fields[STRIDE * edge + DX].toLong()

    /** Vertical extent of [edge], grid units; always positive. */
    fun dy(edge: Int): Long = fields[STRIDE * edge + DY].toLong()

    /**
     * Returns the position where [edge] crosses row [y], as the numerator of a fraction in pixels with denominator `256
     * * dy(edge)`. The fraction is relative to the sample of column 0, so the first column at or after the crossing is
     * the quotient rounded up. Exact.
     */
    fun crossing(edge: Int, y: Int): Long {
        val at = STRIDE * edge
        return Edge.crossing(fields[at + X], fields[at + Y], fields[at + DX], fields[at + DY], y)
    }

    /** Returns the first column whose sample is at or after the crossing of [edge] with row [y]. */
    fun column(edge: Int, y: Int): Int = ceilDiv(crossing(edge, y), ScreenGrid.STEPS * dy(edge)).toInt()

    /** Whether a sample is inside if [windings] is the sum of the windings of the crossings at or left of it. */
    fun isInside(windings: Int): Boolean = fillRule.isInside(windings)

    /**
     * Adds the spans of row [y] to [spans]. This is the reference implementation for [TrapezoidCursor]; it computes
     * each crossing directly.
     *
     * A sample is inside by the sum of the windings of the crossings at or left of it, so only the columns of the
     * crossings matter.
     */
    fun spans(y: Int, spans: Spans) {
        // Collect the crossings, sorted by column
        val columns = LongArray(count)
        var crossings = 0
        for (edge in 0 until count) {
            if (y < start(edge) || y >= end(edge)) continue
            val key = column(edge, y).toLong() shl 32 or (winding(edge) + 1).toLong()
            var i = crossings++
            while (i > 0 && columns[i - 1] > key) {
                columns[i] = columns[i - 1]
                i--
            }
            columns[i] = key
        }

        // Sum up the windings from the left
        var windings = 0
        var spanStart = 0
        for (i in 0 until crossings) {
            val column = (columns[i] shr 32).toInt()
            val wasInside = isInside(windings)
            windings += columns[i].toInt() - 1
            val isInside = isInside(windings)
            if (isInside && !wasInside) spanStart = column
            if (wasInside && !isInside) addClipped(spanStart, column, spans)
        }
    }

    /** Adds the part of a span that is within the raster. */
    fun addClipped(start: Int, end: Int, spans: Spans) {
        val from = maxOf(start, 0)
        val to = minOf(end, width)
        if (from < to) spans.add(from, to)
    }

    companion object {
        private const val START = 0
        private const val END = 1
        private const val X = 2
        private const val Y = 3
        private const val DX = 4
        private const val DY = 5
        private const val WINDING = 6
        private const val STRIDE = 7

        /** Returns the quotient rounded up; [divisor] must be positive. */
        fun ceilDiv(dividend: Long, divisor: Long): Long = -Math.floorDiv(-dividend, divisor)
    }
}

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
