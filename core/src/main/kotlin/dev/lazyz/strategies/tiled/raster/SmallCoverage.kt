package dev.lazyz.strategies.tiled.raster

import dev.lazyz.raster.ScreenGrid

/**
 * The samples that a small triangle covers, computed from its edge functions (contract rule 2.2; see
 * [dev.lazyz.strategies.tiled.raster.TriangleForms]).
 *
 * Half of the triangles of a fine mesh cover nothing, and the coverage of the others varies so much that a processor
 * cannot predict branches. The code therefore has no branches, and always tests a whole square of samples, regardless
 * of the triangle's size. Vertices and samples are less than 2^13 grid steps apart, so 32 bits are enough.
 */
internal object SmallCoverage {
    /** Samples along a side of the square. */
    const val SIDE: Int = 3

    /** Most samples along a side of a triangle's bounds. */
    const val MOST: Int = 16

    /** The bits of all samples of the square. */
    const val ALL: Int = (1 shl SIDE * SIDE) - 1

    /** Column within the square of each of its samples, in two bits each, and the row in the same way. */
    private const val COLUMNS = 0b10_01_00_10_01_00_10_01_00
    private const val ROWS = 0b10_10_10_01_01_01_00_00_00

    /**
     * Returns one bit for each sample of the square of [SIDE] x [SIDE] samples that starts at ([column], [row]): 1 if
     * the triangle covers the sample. Bits are in row order, starting with the lowest bit. The triangle's bounds must
     * have at most [MOST] samples along a side, and must reach the square.
     */
    fun of(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int, column: Int, row: Int): Int {
        // Make the triangle clockwise on the screen; without area no sample is inside
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
        val outside0 = outsideOfThree(first0, first1, first2, dx0, dx1, dx2)
        val outside1 = outsideOfThree(first0 + dy0, first1 + dy1, first2 + dy2, dx0, dx1, dx2)
        val outside2 = outsideOfThree(first0 + 2 * dy0, first1 + 2 * dy1, first2 + 2 * dy2, dx0, dx1, dx2)
        return (outside0 or (outside1 shl SIDE) or (outside2 shl 2 * SIDE)) xor ALL
    }

    /** Returns which of three samples in a row are outside, from the signs of the edge functions. */
    private fun outsideOfThree(v0: Int, v1: Int, v2: Int, dx0: Int, dx1: Int, dx2: Int): Int {
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
