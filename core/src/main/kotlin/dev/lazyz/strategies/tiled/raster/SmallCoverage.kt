package dev.lazyz.strategies.tiled.raster

import dev.lazyz.raster.ScreenGrid

/**
 * Which samples a small triangle covers, by its edge functions (contract rule 2.2; see
 * [dev.lazyz.strategies.tiled.raster.TriangleForms]).
 *
 * Half of the triangles of a fine mesh cover nothing, the others this or that: nothing that a processor could predict. So
 * there are no branches, and a whole square is looked at whatever the size of the triangle. Vertices and samples are
 * less than 2^13 grid steps apart, so 32 bits are enough.
 */
internal object SmallCoverage {
    /** Samples at a side of the square. */
    const val SIDE: Int = 3

    /** Most samples at a side of a triangle's bounds. */
    const val MOST: Int = 16

    /** The bits of all samples of the square. */
    const val ALL: Int = (1 shl SIDE * SIDE) - 1

    /** Column within the square of each of its samples, two bits each, and row, likewise. */
    private const val COLUMNS = 0b10_01_00_10_01_00_10_01_00
    private const val ROWS = 0b10_10_10_01_01_01_00_00_00

    /**
     * Returns a bit for each sample of the square of [SIDE] x [SIDE] samples from ([column], [row]) on, row by row from the
     * lowest bit on: whether the triangle covers it. The triangle's bounds have at most [MOST] samples at a side, and reach
     * the square.
     */
    fun of(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int, column: Int, row: Int): Int {
        // Clockwise on the screen; without area nothing is inside
        val area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        val isCounterclockwise = area shr Int.SIZE_BITS - 1
        val turnX = (bx xor cx) and isCounterclockwise
        val turnY = (by xor cy) and isCounterclockwise
        return clockwise(ax, ay, bx xor turnX, by xor turnY, cx xor turnX, cy xor turnY, column, row) and
            ((-area or area) shr Int.SIZE_BITS - 1)
    }

    private fun clockwise(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int, column: Int, row: Int): Int {
        val sampleX = column * ScreenGrid.STEPS + ScreenGrid.CENTER
        val sampleY = row * ScreenGrid.STEPS + ScreenGrid.CENTER
        return square(
            edge(ax, ay, bx, by, sampleX, sampleY), edge(bx, by, cx, cy, sampleX, sampleY),
            edge(cx, cy, ax, ay, sampleX, sampleY), ScreenGrid.STEPS * (ay - by), ScreenGrid.STEPS * (by - cy),
            ScreenGrid.STEPS * (cy - ay), ScreenGrid.STEPS * (bx - ax), ScreenGrid.STEPS * (cx - bx),
            ScreenGrid.STEPS * (ax - cx),
        )
    }

    private fun square(
        first0: Int,
        first1: Int,
        first2: Int,
        dx0: Int,
        dx1: Int,
        dx2: Int,
        dy0: Int,
        dy1: Int,
        dy2: Int,
    ): Int {
        val outside0 = three(first0, first1, first2, dx0, dx1, dx2)
        val outside1 = three(first0 + dy0, first1 + dy1, first2 + dy2, dx0, dx1, dx2)
        val outside2 = three(first0 + 2 * dy0, first1 + 2 * dy1, first2 + 2 * dy2, dx0, dx1, dx2)
        return (outside0 or (outside1 shl SIDE) or (outside2 shl 2 * SIDE)) xor ALL
    }

    /** Which of three samples in a row are outside: where the sign of an edge function says so. */
    private fun three(v0: Int, v1: Int, v2: Int, dx0: Int, dx1: Int, dx2: Int): Int {
        val a = (v0 or v1 or v2) ushr Int.SIZE_BITS - 1
        val b = (v0 + dx0 or (v1 + dx1) or (v2 + dx2)) ushr Int.SIZE_BITS - 1
        val c = (v0 + 2 * dx0 or (v1 + 2 * dx1) or (v2 + 2 * dx2)) ushr Int.SIZE_BITS - 1
        return a or (b shl 1) or (c shl 2)
    }

    /** The edge function, lowered by one if the edge owns no samples. */
    private fun edge(fromX: Int, fromY: Int, toX: Int, toY: Int, sampleX: Int, sampleY: Int): Int {
        val runX = toX - fromX
        val runY = toY - fromY
        // 1 for an upward edge, or a horizontal one to the right
        val isOwner = (runY or (runY - 1 and -runX)) ushr Int.SIZE_BITS - 1
        return runX * (sampleY - fromY) - runY * (sampleX - fromX) - 1 + isOwner
    }

    /** Column of sample number [place] in the square. */
    fun column(place: Int): Int = COLUMNS ushr 2 * place and 3

    /** Row of sample number [place] in the square. */
    fun row(place: Int): Int = ROWS ushr 2 * place and 3

    /** Returns the bits of the samples in the columns [left] until [right] and the rows [top] until [bottom]. */
    fun within(left: Int, right: Int, top: Int, bottom: Int): Int {
        val columns = below(right) and below(left).inv()
        val rows = below(SIDE * bottom) and below(SIDE * top).inv()
        return columns * 0b1_001_001 and rows
    }

    private fun below(bit: Int): Int = (1 shl bit) - 1
}
