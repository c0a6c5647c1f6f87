package dev.lazyz.strategies.tiled.raster

import dev.lazyz.Counters
import dev.lazyz.raster.ScreenGrid

/**
 * Draws triangles into the keys of a tile. Belongs to one thread.
 *
 * A large triangle is drawn block by block. A block is skipped if the triangle does not reach it, or if the triangle is
 * behind everything visible in the block. Otherwise a [kernel] compares all samples of the block at once. Both tests
 * use the values at the block's corners, because edge functions and depth are linear. A smaller one, most of whose
 * blocks would be covered in part, is drawn row by row, and one of a few samples sample by sample.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993, for rejection;
 * Juan Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988, for blocks.
 */
internal class FineRaster(
    private val tile: VisibilityBuffer,
    private val kernel: BlockKernel,
    private val counters: Counters.Builder,
) {
    // The part of the triangle's bounds that is in the tile, in samples from the tile's first
    private var left = 0
    private var right = 0
    private var top = 0
    private var bottom = 0

    /** Whether the current triangle has so few samples in its bounds that drawing by rows is slower. */
    private var isSmall = false

    /** Whether the current triangle's bounds are so small that drawing by blocks is slower. */
    private var isNarrow = false
    private val rows = TriangleRows()

    /** Begins the triangle with these vertices, in grid units. Returns whether its bounds have samples in the tile. */
    fun begin(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int): Boolean {
        ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { columnStart, rowStart, columnEnd, rowEnd ->
            left = maxOf(columnStart, tile.columnStart) - tile.columnStart
            right = minOf(columnEnd, tile.columnEnd) - tile.columnStart
            top = maxOf(rowStart, tile.rowStart) - tile.rowStart
            bottom = minOf(rowEnd, tile.rowEnd) - tile.rowStart
            isSmall = columnEnd - columnStart <= SmallCoverage.MOST &&
                rowEnd - rowStart <= SmallCoverage.MOST && (columnEnd - columnStart) * (rowEnd - rowStart) <= SMALL
            isNarrow = columnEnd - columnStart <= TriangleRows.MOST && rowEnd - rowStart <= TriangleRows.MOST
        }
        return left < right && top < bottom
    }

    /**
     * Counts so many [fragments], of which so many were in front of what was drawn before. Those [compared] did not
     * update the farthest keys of their blocks, see [VisibilityBuffer.compared]; cheap ones count in part.
     */
    fun count(fragments: Int, passes: Int, compared: Int = fragments) {
        counters.fragments += fragments
        counters.depthEvaluations += fragments
        counters.depthPasses += passes
        tile.compared(compared)
    }

    /**
     * Draws the current triangle, with these vertices. Its depth must be set, with the tile's first sample as the
     * origin.
     */
    fun draw(forms: TriangleForms, ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int) {
        if (isSmall) {
            for (row in top until bottom step SmallCoverage.SIDE) {
                for (column in left until right step SmallCoverage.SIDE) {
                    val covered = SmallCoverage.of(
                        ax, ay, bx, by, cx, cy, tile.columnStart + column,
                        tile.rowStart + row
                    )
                    drawSquare(
                        forms, column, row,
                        covered and SmallCoverage.within(
                            0, minOf(right - column, SmallCoverage.SIDE), 0, minOf(bottom - row, SmallCoverage.SIDE),
                        )
                    )
                }
            }
        } else {
            if (isNarrow && isHidden(forms)) return
            forms.edges(ax, ay, bx, by, cx, cy, tile.columnStart, tile.rowStart)
            if (isNarrow) drawRows(forms) else drawBlocks(forms)
        }
    }

    /** Whether the triangle is behind everything visible in all blocks that its bounds reach. */
    private fun isHidden(forms: TriangleForms): Boolean {
        val size = BlockKernel.BLOCK
        for (row in top / size..(bottom - 1) / size) {
            for (column in left / size..(right - 1) / size) {
                if (forms.nearest < tile.farthestOfBlock[row * tile.blockColumns + column]) return false
            }
        }
        return true
    }

    /** Draws a triangle row by row. Edges and depth must be set, with the tile's first sample as the origin. */
    private fun drawRows(forms: TriangleForms) {
        rows.begin(forms, left, right, top)
        var covered = 0
        var passes = 0
        for (row in top until bottom) {
            val start = rows.start
            val length = rows.end - start
            if (length > 0) {
                covered += length
                val z = forms.z + forms.zdx * start + forms.zdy * row
                passes += tile.lower(row * tile.stride + start, length, z, forms.zdx, forms.rank)
            }
            rows.next()
        }
        count(covered, passes, covered / ROWS_PER_UPDATE)
    }

    /** Draws the samples [coverage] of the square that starts at ([left], [top]) of the tile, see [SmallCoverage]. */
    private fun drawSquare(forms: TriangleForms, left: Int, top: Int, coverage: Int) {
        val keys = tile.keys
        var passes = 0
        var rest = coverage
        while (rest != 0) {
            val place = Integer.numberOfTrailingZeros(rest)
            rest = rest and (rest - 1)
            val row = top + SmallCoverage.row(place)
            val column = left + SmallCoverage.column(place)
            val key = forms.keyAt(column, row)
            val at = row * tile.stride + column
            if (key < keys[at]) {
                keys[at] = key
                passes++
            }
        }
        count(Integer.bitCount(coverage), passes)
    }

    /** Draws a triangle block by block. Edges and depth must be set, with the tile's first sample as the origin. */
    private fun drawBlocks(forms: TriangleForms) {
        kernel.begin(forms)
        val size = BlockKernel.BLOCK
        val last = size - 1
        // Differences between a form's value at a block's first sample and its greatest and least value in the block
        val most0 = last * (maxOf(forms.e0dx, 0L) + maxOf(forms.e0dy, 0L))
        val most1 = last * (maxOf(forms.e1dx, 0L) + maxOf(forms.e1dy, 0L))
        val most2 = last * (maxOf(forms.e2dx, 0L) + maxOf(forms.e2dy, 0L))
        val least0 = last * (minOf(forms.e0dx, 0L) + minOf(forms.e0dy, 0L))
        val least1 = last * (minOf(forms.e1dx, 0L) + minOf(forms.e1dy, 0L))
        val least2 = last * (minOf(forms.e2dx, 0L) + minOf(forms.e2dy, 0L))
        val isGentle = Math.abs(forms.zdx) < GENTLE && Math.abs(forms.zdy) < GENTLE
        val leastZ = last * (minOf(forms.zdx, 0L) + minOf(forms.zdy, 0L))
        val width = tile.columnEnd - tile.columnStart
        val height = tile.rowEnd - tile.rowStart
        var covered = 0
        var passes = 0
        for (blockRow in top / size..(bottom - 1) / size) {
            val row = blockRow * size
            val rows = minOf(size, height - row)
            for (blockColumn in left / size..(right - 1) / size) {
                // A triangle behind everything visible in the block is hidden
                val column = blockColumn * size
                val block = blockRow * tile.blockColumns + blockColumn
                val z = forms.z + forms.zdx * column + forms.zdy * row
                val nearest = if (isGentle) nearest(z + leastZ, forms) else forms.nearest
                if (nearest >= tile.farthestOfBlock[block]) continue

                // Outside one edge, inside all edges, or neither
                val v0 = forms.e0 + forms.e0dx * column + forms.e0dy * row
                val v1 = forms.e1 + forms.e1dx * column + forms.e1dy * row
                val v2 = forms.e2 + forms.e2dx * column + forms.e2dy * row
                if (v0 + most0 or (v1 + most1) or (v2 + most2) < 0) continue
                val columns = minOf(size, width - column)
                val at = row * tile.stride + column
                val isWhole = v0 + least0 or (v1 + least1) or (v2 + least2) >= 0 && rows == size && columns == size
                if (isWhole) {
                    covered += size * size
                    passes += kernel.whole(tile.keys, at, tile.stride, z, tile.farthestOfBlock, block)
                } else {
                    val result = kernel.part(
                        tile.keys, at, tile.stride, v0, v1, v2, z, columns, rows, tile.farthestOfBlock, block,
                    )
                    covered += (result ushr Int.SIZE_BITS).toInt()
                    passes += result.toInt()
                }
            }
        }
        count(covered, passes, 0)
    }

    /**
     * A lower bound of a triangle's keys in a block, from its depth at the corner where depth is nearest. The corner
     * may lie outside the triangle, and its depth out of range. If the depth is less than 0, the bound rejects nothing.
     * The depth cannot wrap around to the far end of the range: if there is anything to draw, the block has a covered
     * sample, and depth changes by less than 2^62 within a block.
     */
    private fun nearest(corner: Long, forms: TriangleForms): Long =
        maxOf(forms.nearest, (corner and BlockKernel.DEPTH_BITS) or forms.rank)

    private companion object {
        /** A triangle is drawn sample by sample if its bounds have at most this many samples. */
        const val SMALL = 16

        /** Samples that are compared in rows are so many times as cheap as single ones. */
        const val ROWS_PER_UPDATE = 4

        /** 2^58: depth that changes by less than this per sample changes by less than 2^62 in a block. */
        const val GENTLE = 1L shl 58
    }
}
