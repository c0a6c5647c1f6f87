package dev.lazyz.strategies.tiled

import dev.lazyz.ChangedPrimitive
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.raster.boundsIn
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.SmallCoverage
import dev.lazyz.strategies.tiled.raster.TileGrid

/**
 * Upper bounds of the memory that [TiledRenderer] takes for a frame in memory, in bytes, from the bounds of its
 * primitives and the table of [HeapLayout]. What is hidden counts like what is visible, so a scene of many layers takes
 * less. Cost: one pass over all primitives.
 *
 * @param threads number of threads, including the calling thread
 */
internal class TiledMemory(private val frame: Frame, tileSize: Int, private val threads: Int) {
    private val region = frame.region
    private val grid = TileGrid(region, tileSize)

    /** How many bands are in progress at a time. */
    private val bandsAtWork =
        TiledRendering.bandsAtWork(grid, minOf(threads.toLong(), grid.columns.toLong() * grid.bands).toInt())

    /** Bytes of one row of samples, as an array, of which there are [rowArrays]. */
    val rowBytes: Long = Int.SIZE_BYTES * region.width.toLong()

    /** Number of arrays of rows: colour, depth and primitive of each row of the bands in progress. */
    val rowArrays: Long = 3L * grid.tileHeight * bandsAtWork

    /** The triangles of meshes and the fragments of small ones, by tile. */
    val bins: Long = bins()

    /** All other primitives, by tile, with the spans that tiles share. */
    val singles: Long = singles()

    /** The translucent fragments of the tiles that are rendered. */
    val layers: Long = if (frame.hasTranslucency) threads * fragmentsOfATile() * HeapLayout.TILE_LAYER else 0

    /** What each thread needs in any case. */
    val workers: Long = threads * (HeapLayout.THREAD + HeapLayout.TILE_SAMPLE * tileSize * tileSize)

    private fun bins(): Long {
        val bandsAtOnce = TriangleBins.bandsAtOnce(grid)
        val groups = LongArray((grid.bands - 1) / bandsAtOnce + 1)
        for (number in frame.content.batches.indices) {
            val batch = frame.content.triangleBatch(number)
            for (triangle in 0 until batch.count) {
                if (batch.isDrawn(triangle)) add(batch, triangle, groups, bandsAtOnce)
            }
        }

        // The bins of the next bands are made while those before are still in use
        return minOf(groups.size, 2) * groups.max()
    }

    /** Adds the tiles that a triangle may reach, or the samples that it may cover if it is small, to [groups]. */
    private fun add(batch: TriangleBatch, triangle: Int, groups: LongArray, bandsAtOnce: Int) {
        batch.vertices(triangle) { ax, ay, bx, by, cx, cy ->
            ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { left, top, right, bottom ->
                val columnStart = maxOf(left, region.columnStart)
                val columnEnd = minOf(right, region.columnEnd)
                val rowStart = maxOf(top, region.rowStart)
                val rowEnd = minOf(bottom, region.rowEnd)
                if (columnStart >= columnEnd || rowStart >= rowEnd) return
                val first = grid.bandOf(rowStart)
                val last = grid.bandOf(rowEnd - 1)
                val tiles = grid.columnOf(columnEnd - 1) - grid.columnOf(columnStart) + 1L
                val isSmall = right - left <= SmallCoverage.SIDE && bottom - top <= SmallCoverage.SIDE
                for (group in first / bandsAtOnce..last / bandsAtOnce) {
                    val bands = minOf(last, (group + 1) * bandsAtOnce - 1) - maxOf(first, group * bandsAtOnce) + 1
                    groups[group] += if (isSmall) {
                        HeapLayout.TILE_FRAGMENT * (columnEnd - columnStart) * (rowEnd - rowStart)
                    } else {
                        HeapLayout.TILE_TRIANGLE * tiles * bands
                    }
                }
            }
        }
    }

    private fun singles(): Long {
        val all = frame.content.singles
        val changes = LongArray(grid.bands + 1)
        for (primitive in all) {
            val box = primitive.boundsIn(region) ?: continue
            val bytes = HeapLayout.MEMBER + spanBytes(primitive, box)
            changes[grid.bandOf(box.rowStart)] += bytes
            changes[grid.bandOf(box.rowEnd - 1) + 1] -= bytes
        }
        val most = changes.asSequence().runningReduce { sum, change -> sum + change }.max()
        return HeapLayout.ARRIVAL * all.size + bandsAtWork * most
    }

    /** Bytes of the spans of a primitive in one band, if [box] is the part of its bounds in the region. */
    private fun spanBytes(primitive: Primitive, box: Region): Long {
        val columns = box.width.toLong()
        val mostSpans = if (primitive.isMasked()) columns else primitive.heldBytes / HeapLayout.SPAN_EDGES
        val rowBytes = Int.SIZE_BYTES + HeapLayout.MEMBER_SPAN * mostSpans.coerceIn(1, columns)
        return HeapLayout.MEMBER_SPANS + minOf(box.height, grid.tileHeight) * rowBytes
    }

    private fun Primitive.isMasked(): Boolean =
        this is MaskedPrimitive || (this is ChangedPrimitive && whole.isMasked())

    /** Returns a number that the translucent fragments of no tile exceed. */
    private fun fragmentsOfATile(): Long {
        // Cells of whole tiles, so few that each primitive can be counted in all that it reaches
        var cell = grid.size
        while (maxOf(region.width, region.height) / cell >= MOST_CELLS) cell *= 2
        val across = (region.width - 1) / cell + 1
        val fragments = LongArray(across * ((region.height - 1) / cell + 1))
        val tile = grid.size.toLong() * grid.size
        for (primitive in frame.content.singles) {
            val box = (if (primitive.isTranslucent) primitive.boundsIn(region) else null) ?: continue
            val most = minOf(box.size, tile)
            for (row in (box.rowStart - region.rowStart) / cell..(box.rowEnd - 1 - region.rowStart) / cell) {
                val first = (box.columnStart - region.columnStart) / cell
                val last = (box.columnEnd - 1 - region.columnStart) / cell
                for (column in first..last) fragments[row * across + column] += most
            }
        }
        return fragments.max()
    }

    private companion object {
        /** Most cells along a side. */
        const val MOST_CELLS = 64
    }
}
