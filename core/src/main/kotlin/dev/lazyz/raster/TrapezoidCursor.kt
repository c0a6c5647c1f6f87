package dev.lazyz.raster

import dev.lazyz.HeapLayout
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

/**
 * Returns the spans of a polygon by dividing it into trapezoids and stepping their sides from row to row.
 *
 * Between two rows at which an edge begins, ends or crosses another, a polygon consists of trapezoids side by side. In
 * such a slab of rows nothing has to be sorted or counted, and each side moves by one exact step a row.
 *
 * Source: the depth-buffer algorithm of the computer graphics notes of the University of California, Davis, which
 * divides polygons into trapezoids and updates depth and intensity incrementally along each. There, a side is a real
 * number. Here, it is a column and an exact remainder (Bresenham's idea), so that stepping gives the same samples as
 * evaluating the edge.
 */
internal class TrapezoidCursor(private val edges: EdgeTable, private var y: Int) : SpanCursor {
    /** The row after the last row of the current slab. */
    private var slabEnd = y

    /** Edges that cross the current rows. They are sorted from left to right while a slab is set up. */
    private val active = IntArray(edges.count)

    /** Sides of the current trapezoids, alternately left and right: the column of the edge at row y. */
    private val column = IntArray(edges.count)

    /**
     * For each side the remainder, in 0 until 256 dy: how far the sample of the column is to the right of the crossing.
     */
    private val remainder = LongArray(edges.count)

    /** For each side the steps of column and remainder from one row to the next, and the divisor of the remainder. */
    private val columnStep = IntArray(edges.count)
    private val remainderStep = LongArray(edges.count)
    private val divisor = LongArray(edges.count)
    private var sides = 0

    /** Bytes of this cursor. */
    val heldBytes: Long get() = HeapLayout.EDGE_CURSOR + HeapLayout.CURSOR_EDGE * edges.count

    override fun next(spans: Spans) {
        spans.clear()
        if (y >= slabEnd) beginSlab()
        for (side in 0 until sides step 2) edges.addClipped(column[side], column[side + 1], spans)
        y++
        if (y < slabEnd) for (side in 0 until sides) step(side)
    }

    private fun step(side: Int) {
        column[side] += columnStep[side]
        val rest = remainder[side] - remainderStep[side]
        if (rest < 0) {
            column[side]++
            remainder[side] = rest + divisor[side]
        } else {
            remainder[side] = rest
        }
    }

    /** Sets up the trapezoids that begin at row y. */
    private fun beginSlab() {
        // Find the edges that cross this row, and the next row at which an edge starts or ends
        var count = 0
        slabEnd = if (y < edges.rowStart) edges.rowStart else maxOf(edges.rowEnd, y + 1)
        for (edge in 0 until edges.count) {
            val start = edges.start(edge)
            val end = edges.end(edge)
            if (y >= end) continue
            if (y < start) {
                slabEnd = minOf(slabEnd, start)
            } else {
                slabEnd = minOf(slabEnd, end)
                insertSorted(edge, count++)
            }
        }

        // If edges cross each other within the slab, halve it until they do not
        while (!isOrderedAt(slabEnd - 1, count)) slabEnd = y + (slabEnd - y) / 2

        // Keep the edges at which the fill rule changes between outside and inside
        sides = 0
        var windings = 0
        for (i in 0 until count) {
            val wasInside = edges.isInside(windings)
            windings += edges.winding(active[i])
            if (edges.isInside(windings) != wasInside) beginSide(active[i])
        }
    }

    private fun insertSorted(edge: Int, count: Int) {
        var i = count
        while (i > 0 && isRightOf(active[i - 1], edge, y)) {
            active[i] = active[i - 1]
            i--
        }
        active[i] = edge
    }

    private fun isOrderedAt(row: Int, count: Int): Boolean {
        for (i in 1 until count) if (crossingOrder(active[i - 1], active[i], row) > 0) return false
        return true
    }

    /** Whether [a] is to the right of [b] at [row]; if both meet there, whether it is to the right below. */
    private fun isRightOf(a: Int, b: Int, row: Int): Boolean {
        val order = crossingOrder(a, b, row)
        if (order != 0) return order > 0
        return edges.dx(a) * edges.dy(b) > edges.dx(b) * edges.dy(a)
    }

    /** Compares the positions where two edges cross [row]: negative if [a] is to the left. Exact. */
    private fun crossingOrder(a: Int, b: Int, row: Int): Int {
        val crossingA = edges.crossing(a, row)
        val crossingB = edges.crossing(b, row)
        val columnA = Math.floorDiv(crossingA, edges.dy(a))
        val columnB = Math.floorDiv(crossingB, edges.dy(b))
        if (columnA != columnB) return columnA.compareTo(columnB)

        // Same integer part: compare the remainders over dy. Both are below 2^28, so the products are exact
        val restA = crossingA - columnA * edges.dy(a)
        val restB = crossingB - columnB * edges.dy(b)
        return (restA * edges.dy(b)).compareTo(restB * edges.dy(a))
    }

    private fun beginSide(edge: Int) {
        val side = sides++
        val dx = edges.dx(edge)
        val dy = edges.dy(edge)
        val crossing = edges.crossing(edge, y)
        divisor[side] = ScreenGrid.STEPS * dy
        column[side] = EdgeTable.ceilDiv(crossing, divisor[side]).toInt()
        remainder[side] = column[side] * divisor[side] - crossing
        columnStep[side] = Math.floorDiv(dx, dy).toInt()
        remainderStep[side] = ScreenGrid.STEPS * (dx - columnStep[side] * dy)
    }
}

/** Bytes of this cursor; of a custom one they are not known. */
internal val SpanCursor.bytes: Long get() = if (this is TrapezoidCursor) heldBytes else HeapLayout.CURSOR
