package dev.lazyz.raster

import dev.lazyz.FillRule
import dev.lazyz.Spans

/**
 * The edges of a polygon that cross rows of the raster, as exact integers (contract rule 2).
 *
 * Vertices are on the 1/256 pixel grid. Row y is crossed by an edge whose upper end is at the row's samples or above
 * and whose lower end is below them; the crossing covers the samples at it and to its right. Both "at" together are the
 * top-left rule.
 *
 * @param xs vertices' x, grid units, contour after contour
 * @param ys vertices' y, grid units
 * @param contourEnds for each contour the number of vertices up to its end
 * @param fillRule what is inside
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
    /** Fields of each edge, [STRIDE] numbers an edge. */
    private val fields: IntArray

    /** Number of edges. */
    val count: Int

    /** First row that an edge crosses. */
    val rowStart: Int

    /** Row after the last that an edge crosses; at most [rowStart] if there is none. */
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
                // Keep an edge if it crosses a row of samples; horizontal ones never do
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

    /** Bytes of the table: its fields, counted as if each took 8 bytes, and its array. */
    val heldBytes: Long get() = 72L + Int.SIZE_BYTES * fields.size

    /** First row that edge [edge] crosses. */
    fun start(edge: Int): Int = fields[STRIDE * edge + START]

    /** Row after the last that edge [edge] crosses. */
    fun end(edge: Int): Int = fields[STRIDE * edge + END]

    /** +1 if the contour runs downward along [edge], -1 if it runs upward. */
    fun winding(edge: Int): Int = fields[STRIDE * edge + WINDING]

    /** Horizontal extent of [edge], grid units, to the right. */
    fun dx(edge: Int): Long = fields[STRIDE * edge + DX].toLong()

    /** Vertical extent of [edge], grid units; positive. */
    fun dy(edge: Int): Long = fields[STRIDE * edge + DY].toLong()

    /**
     * Returns where [edge] crosses row [y], as a numerator over `256 * dy(edge)`, in pixels, such that the first column
     * at or after the crossing is the quotient rounded up. Exact.
     */
    fun crossing(edge: Int, y: Int): Long {
        val at = STRIDE * edge
        val dy = fields[at + DY].toLong()
        val down = (y * ScreenGrid.STEPS + ScreenGrid.CENTER - fields[at + Y]).toLong()
        return (fields[at + X] - ScreenGrid.CENTER) * dy + down * fields[at + DX]
    }

    /** Returns the first column whose sample is at or after the crossing of [edge] with row [y]. */
    fun column(edge: Int, y: Int): Int = ceilDiv(crossing(edge, y), ScreenGrid.STEPS * dy(edge)).toInt()

    /** Whether samples with this sum of windings to their left are inside. */
    fun isInside(windings: Int): Boolean = if (fillRule == FillRule.EVEN_ODD) windings and 1 != 0 else windings != 0

    /**
     * Adds the spans of row [y] to [spans]: the plain twin of [TrapezoidCursor], each crossing computed by itself.
     *
     * A sample is inside by the sum of the windings of the crossings at or left of it, so only their columns matter.
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

    /** Adds the part of a span that lies within the raster. */
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

        /** Returns the quotient rounded up; the divisor is positive. */
        fun ceilDiv(dividend: Long, divisor: Long): Long = -Math.floorDiv(-dividend, divisor)
    }
}
