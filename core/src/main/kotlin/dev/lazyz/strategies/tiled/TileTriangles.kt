package dev.lazyz.strategies.tiled

import dev.lazyz.Counters
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.BlockKernel
import dev.lazyz.strategies.tiled.raster.SmallCoverage
import dev.lazyz.strategies.tiled.raster.TileKeys
import dev.lazyz.strategies.tiled.raster.TriangleForms

/**
 * Draws triangles into the keys of a tile, block by block. Belongs to one thread.
 *
 * A block is passed over if the triangle does not reach it, or if all of the triangle in it is behind all that is there;
 * otherwise a [kernel] compares all its samples at once. Both questions are answered exactly by the values at corners, for
 * edge functions and depth are linear. Triangles of a few samples are drawn sample by sample.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993, for rejection; Juan
 * Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988, for blocks.
 */
internal class TileTriangles(
    private val tile: TileKeys,
    private val kernel: BlockKernel,
    private val counters: Counters,
) {
    // The part of the triangle's bounds that is in the tile, in samples from the tile's first
    private var left = 0
    private var right = 0
    private var top = 0
    private var bottom = 0

    /** Whether the triangle that was begun has so few samples in its bounds that blocks don't pay. */
    private var isSmall = false

    /** Begins the triangle with these vertices, grid units; returns whether its bounds have samples in the tile. */
    fun begin(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int): Boolean {
        val columnStart = ScreenGrid.firstSample(minOf(ax, minOf(bx, cx)))
        val columnEnd = ScreenGrid.firstSample(maxOf(ax, maxOf(bx, cx)))
        val rowStart = ScreenGrid.firstSample(minOf(ay, minOf(by, cy)))
        val rowEnd = ScreenGrid.firstSample(maxOf(ay, maxOf(by, cy)))
        left = maxOf(columnStart, tile.columnStart) - tile.columnStart
        right = minOf(columnEnd, tile.columnEnd) - tile.columnStart
        top = maxOf(rowStart, tile.rowStart) - tile.rowStart
        bottom = minOf(rowEnd, tile.rowEnd) - tile.rowStart
        isSmall = columnEnd - columnStart <= SmallCoverage.MOST &&
            rowEnd - rowStart <= SmallCoverage.MOST && (columnEnd - columnStart) * (rowEnd - rowStart) <= SMALL
        return left < right && top < bottom
    }

    /** Draws the fragments of triangles so small that [bins] has drawn them. */
    fun lower(bins: TriangleBins, band: Int, column: Int) {
        val count = bins.fragmentCount(band, column)
        counters.fragments += count
        counters.depthEvaluations += count
        counters.depthPasses += bins.lower(band, column, tile.keys)
        tile.compared(count)
    }

    /** Draws the triangle that was begun, with these vertices. Depth is set, with the tile's first sample as the origin. */
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
            forms.edges(ax, ay, bx, by, cx, cy, tile.columnStart, tile.rowStart)
            drawBlocks(forms)
        }
    }

    /** Draws the samples [coverage] of the square from ([left], [top]) of the tile on, see [SmallCoverage]. */
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
        val covered = Integer.bitCount(coverage)
        counters.fragments += covered
        counters.depthEvaluations += covered
        counters.depthPasses += passes
        tile.compared(covered)
    }

    /** Draws a triangle block by block. Edges and depth are set, with the tile's first sample as the origin. */
    private fun drawBlocks(forms: TriangleForms) {
        kernel.begin(forms)
        val size = BlockKernel.BLOCK
        val last = size - 1
        // From a block's first sample to where each form is greatest and least in it
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
        var covered = 0L
        var passes = 0
        for (blockRow in top / size..(bottom - 1) / size) {
            val row = blockRow * size
            val rows = minOf(size, height - row)
            for (blockColumn in left / size..(right - 1) / size) {
                // What is behind all that the block shows is hidden
                val column = blockColumn * size
                val block = blockRow * tile.blockColumns + blockColumn
                val z = forms.z + forms.zdx * column + forms.zdy * row
                val nearest = if (isGentle) nearest(z + leastZ, forms) else forms.nearest
                if (nearest >= tile.farthestOfBlock[block]) continue

                // Outside one edge, inside all, or neither
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
                    covered += result ushr Int.SIZE_BITS
                    passes += result.toInt()
                }
            }
        }
        counters.fragments += covered
        counters.depthEvaluations += covered
        counters.depthPasses += passes
    }

    /**
     * The least key of a triangle in a block, from its depth at the nearest corner. The corner may be off the triangle,
     * and its depth out of range: before 0 it proves nothing, and it cannot wrap around behind the range, for in the
     * block is a sample that is covered, or there is nothing to draw, and depth changes by less than 2^62 in a block.
     */
    private fun nearest(corner: Long, forms: TriangleForms): Long =
        maxOf(forms.nearest, (corner and BlockKernel.DEPTH_BITS) or forms.rank)

    private companion object {
        /** Samples of the bounds up to which a triangle is drawn sample by sample. */
        const val SMALL = 16

        /** 2^58: depth that changes by less from a sample to the next changes by less than 2^62 in a block. */
        const val GENTLE = 1L shl 58
    }
}
