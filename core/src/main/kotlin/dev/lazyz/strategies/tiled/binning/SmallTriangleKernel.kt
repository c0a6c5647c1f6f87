package dev.lazyz.strategies.tiled.binning

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.strategies.tiled.raster.SmallCoverage

/**
 * Computes the coverage of small triangles, many at a time: half of the triangles of a fine mesh cover nothing.
 *
 * All kernels give the same bits. Results are valid until the next call; belongs to one thread.
 */
internal abstract class SmallTriangleKernel {
    /** First column of each triangle's square of [SmallCoverage.SIDE] x [SmallCoverage.SIDE] samples. */
    @JvmField val left: IntArray = IntArray(COUNT)

    /** First row of each square. */
    @JvmField val top: IntArray = IntArray(COUNT)

    /** The covered samples, see [SmallCoverage], or [LARGE] for a triangle whose bounds exceed the square. */
    @JvmField val covered: IntArray = IntArray(COUNT)

    /**
     * Computes the coverage of the triangles [first] until [first] + [count] of [batch]; [count] is at most [COUNT].
     */
    abstract fun cover(batch: TriangleBatch, first: Int, count: Int)

    /** Computes the coverage of one triangle and stores it at index [i]. */
    protected fun coverOne(batch: TriangleBatch, triangle: Int, i: Int) {
        batch.vertices(triangle) { ax, ay, bx, by, cx, cy ->
            ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { column, row, columnEnd, rowEnd ->
                left[i] = column
                top[i] = row
                covered[i] = if (columnEnd - column <= SmallCoverage.SIDE && rowEnd - row <= SmallCoverage.SIDE) {
                    SmallCoverage.of(ax, ay, bx, by, cx, cy, column, row)
                } else {
                    LARGE
                }
            }
        }
    }

    companion object {
        /** Most triangles at a time. */
        const val COUNT: Int = 256

        /** Marks a triangle that is not small. */
        const val LARGE: Int = -1
    }
}

/** Processes one triangle after the other. */
internal class ScalarSmallTriangleKernel : SmallTriangleKernel() {
    override fun cover(batch: TriangleBatch, first: Int, count: Int) {
        for (i in 0 until count) coverOne(batch, first + i, i)
    }
}
