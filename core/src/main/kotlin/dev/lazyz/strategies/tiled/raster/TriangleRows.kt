package dev.lazyz.strategies.tiled.raster

import dev.lazyz.raster.ScreenGrid

/**
 * The samples that a triangle covers in one row after the other, without a division per row: what is divided by an
 * edge's step from column to column is kept as quotient and rest, which are stepped from row to row. All values are
 * exact. For triangles whose bounds have at most [MOST] samples along a side; reused for each triangle.
 *
 * Source: Jack Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4 (1965), for the
 * steps.
 */
internal class TriangleRows {
    private val edge0 = EdgeSteps()
    private val edge1 = EdgeSteps()
    private val edge2 = EdgeSteps()
    private var left = 0
    private var right = 0

    /** Begins with row [top], between the columns [left] and [right]. The origin is that of [forms]. */
    fun begin(forms: TriangleForms, left: Int, right: Int, top: Int) {
        this.left = left
        this.right = right
        edge0.begin(forms.e0 + forms.e0dx * left + forms.e0dy * top, forms.e0dx, forms.e0dy)
        edge1.begin(forms.e1 + forms.e1dx * left + forms.e1dy * top, forms.e1dx, forms.e1dy)
        edge2.begin(forms.e2 + forms.e2dx * left + forms.e2dy * top, forms.e2dx, forms.e2dy)
    }

    /** The first column that is covered in this row. */
    val start: Int get() = left + maxOf(0, edge0.first, maxOf(edge1.first, edge2.first))

    /** The column after the last that is covered; at most [start] if none is. */
    val end: Int get() = left + minOf(right - left, edge0.end, minOf(edge1.end, edge2.end))

    /** Goes to the next row. */
    fun next() {
        edge0.next()
        edge1.next()
        edge2.next()
    }

    companion object {
        /** Most samples along a side of a triangle's bounds, so that all values fit into 32 bits. */
        const val MOST: Int = 128
    }
}

/**
 * The columns on the inner side of one edge, row by row. Its function changes by a multiple of [ScreenGrid.STEPS] from
 * sample to sample, so the sign is that of the function divided by it and rounded down.
 */
private class EdgeSteps {
    private var quotient = 0
    private var rest = 0
    private var quotientStep = 0
    private var restStep = 0
    private var divisor = 0

    /** All bits, if the triangle is right of the edge, otherwise none. */
    private var isLeft = 0

    /** Begins with an edge function's [value] at a row's first column, and its steps by column and row. */
    fun begin(value: Long, dx: Long, dy: Long) {
        var first = (value shr ScreenGrid.SHIFT).toInt()
        var step = (dy shr ScreenGrid.SHIFT).toInt()
        val run = (dx shr ScreenGrid.SHIFT).toInt()
        isLeft = -run shr Int.SIZE_BITS - 1
        divisor = Math.abs(run)
        if (run == 0) {
            // All columns or none
            first = first * TriangleRows.MOST + TriangleRows.MOST - 1
            step *= TriangleRows.MOST
            divisor = 1
        }
        quotient = Math.floorDiv(first, divisor)
        rest = first - quotient * divisor
        quotientStep = Math.floorDiv(step, divisor)
        restStep = step - quotientStep * divisor
    }

    /** The first column inside, or one outside of the row. */
    val first: Int get() = -quotient and isLeft

    /** The column after the last one inside, or one outside of the row. */
    val end: Int get() = (quotient + 1 and isLeft.inv()) or (Int.MAX_VALUE and isLeft)

    /** Goes to the next row. */
    fun next() {
        val over = rest + restStep - divisor
        val isOver = (over shr Int.SIZE_BITS - 1).inv()
        quotient += quotientStep - isOver
        rest = over + (divisor and isOver.inv())
    }
}
