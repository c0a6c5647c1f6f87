package dev.lazyz.strategies.tiled

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.raster.reaches
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.SmallCoverage
import dev.lazyz.strategies.tiled.raster.TileGrid

/**
 * Upper bounds of the memory that [Tiled] takes for a frame in memory, in bytes, from the bounds of its primitives.
 * What is hidden counts like what is visible, so a scene of many layers takes less. Cost: one pass over all
 * primitives.
 *
 * @param threads number of threads, including the calling thread
 */
internal class TiledMemory(private val frame: Frame, tileSize: Int, private val threads: Int) {
    private val region = frame.region
    private val grid = TileGrid(region, tileSize)
    private val bandsAtOnce = TriangleBins.bandsAtOnce(grid)
    private val groups = (grid.bands - 1) / bandsAtOnce + 1

    /** How many bands are in progress at a time. */
    private val bandsAtWork =
        Rendering.bandsAtWork(grid, minOf(threads.toLong(), grid.columns.toLong() * grid.bands).toInt())

    /** Bytes of one row of samples, as an array, of which there are [rowArrays]. */
    val rowBytes: Long = Int.SIZE_BYTES * region.width.toLong()

    /** Number of arrays of rows: colour, depth and primitive of each row of the bands in progress. */
    val rowArrays: Long = 3L * grid.tileHeight * bandsAtWork

    /** The triangles of meshes and the fragments of small ones, by tile. */
    val bins: Long = bins()

    /** All other primitives, by tile, with the spans that tiles share. */
    val singles: Long = singles()

    /** The translucent fragments of the tiles that are rendered. */
    val layers: Long = if (frame.hasTranslucency) threads * fragmentsOfATile() * LAYER_BYTES else 0

    /** What each thread needs in any case. */
    val workers: Long = threads * (THREAD_BYTES + PLACE_BYTES * tileSize * tileSize)

    private fun bins(): Long {
        val batches = frame.content.batches
        if (batches.isEmpty()) return 0
        val pairs = LongArray(groups)
        val fragments = LongArray(groups)
        for (number in batches.indices) {
            val batch = frame.content.triangleBatch(number)
            for (triangle in 0 until batch.count) if (batch.isDrawn(triangle)) add(batch, triangle, pairs, fragments)
        }
        val most = (0 until groups).maxOf { PAIR_BYTES * pairs[it] + FRAGMENT_BYTES * fragments[it] }

        // The bins of the next bands are made while those before are still in use
        return minOf(groups, 2) * most
    }

    /**
     * Adds the tiles that a triangle may reach, or the samples that it may cover if it is small, to those of groups.
     */
    private fun add(batch: TriangleBatch, triangle: Int, pairs: LongArray, fragments: LongArray) {
        batch.vertices(triangle) { ax, ay, bx, by, cx, cy ->
            ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { left, top, right, bottom ->
                val isSmall = right - left <= SmallCoverage.SIDE && bottom - top <= SmallCoverage.SIDE
                add(left, top, right, bottom, isSmall, pairs, fragments)
            }
        }
    }

    private fun add(
        left: Int,
        top: Int,
        right: Int,
        bottom: Int,
        isSmall: Boolean,
        pairs: LongArray,
        fragments: LongArray,
    ) {
        val columnStart = maxOf(left, region.columnStart)
        val columnEnd = minOf(right, region.columnEnd)
        val rowStart = maxOf(top, region.rowStart)
        val rowEnd = minOf(bottom, region.rowEnd)
        if (columnStart >= columnEnd || rowStart >= rowEnd) return
        val first = grid.bandOf(rowStart)
        val last = grid.bandOf(rowEnd - 1)
        for (group in first / bandsAtOnce..last / bandsAtOnce) {
            if (isSmall) {
                fragments[group] += (columnEnd - columnStart).toLong() * (rowEnd - rowStart)
            } else {
                val columns = grid.columnOf(columnEnd - 1) - grid.columnOf(columnStart) + 1L
                val bands = minOf(last, (group + 1) * bandsAtOnce - 1) - maxOf(first, group * bandsAtOnce) + 1L
                pairs[group] += columns * bands
            }
        }
    }

    private fun singles(): Long {
        val all = frame.content.singles
        val changes = LongArray(grid.bands + 1)
        for (primitive in all) {
            if (!primitive.reaches(region)) continue
            val first = grid.bandOf(maxOf(primitive.rowStart, region.rowStart))
            val last = grid.bandOf(minOf(primitive.rowEnd, region.rowEnd) - 1)
            val bytes = MEMBER_BYTES + spanBytes(primitive)
            changes[first] += bytes
            changes[last + 1] -= bytes
        }
        var sum = 0L
        var most = 0L
        for (band in 0 until grid.bands) {
            sum += changes[band]
            most = maxOf(most, sum)
        }
        return ARRIVAL_BYTES * all.size + bandsAtWork * most
    }

    /** Bytes of the spans of a primitive in one band. */
    private fun spanBytes(primitive: Primitive): Long {
        val columns = minOf(primitive.columnEnd, region.columnEnd) - maxOf(primitive.columnStart, region.columnStart)
        val mostSpans = if (primitive is MaskedPrimitive) columns.toLong() else primitive.heldBytes / EDGES_BYTES
        val height = minOf(primitive.rowEnd, region.rowEnd) - maxOf(primitive.rowStart, region.rowStart)
        val rows = minOf(height, grid.tileHeight)
        return SPANS_BYTES + rows * (Int.SIZE_BYTES + SPAN_BYTES * mostSpans.coerceIn(1, maxOf(columns, 1).toLong()))
    }

    /** Returns a number that the translucent fragments of no tile exceed. */
    private fun fragmentsOfATile(): Long {
        // Cells of whole tiles, so few that they take little memory
        var cell = grid.size
        while (maxOf(region.width, region.height) / cell >= MOST_CELLS) cell *= 2
        val across = (region.width - 1) / cell + 1
        val down = (region.height - 1) / cell + 1
        val large = LongArray((across + 1) * (down + 1))
        val small = LongArray(across * down)
        for (primitive in frame.content.singles) {
            if (!primitive.isTranslucent || !primitive.reaches(region)) continue
            val left = maxOf(primitive.columnStart, region.columnStart) - region.columnStart
            val right = minOf(primitive.columnEnd, region.columnEnd) - region.columnStart
            val top = maxOf(primitive.rowStart, region.rowStart) - region.rowStart
            val bottom = minOf(primitive.rowEnd, region.rowEnd) - region.rowStart
            val area = (right - left).toLong() * (bottom - top)
            val firstColumn = left / cell
            val lastColumn = (right - 1) / cell
            val firstRow = top / cell
            val lastRow = (bottom - 1) / cell
            if (area < grid.size.toLong() * grid.size) {
                for (row in firstRow..lastRow) {
                    for (column in firstColumn..lastColumn) {
                        small[row * across + column] +=
                            area
                    }
                }
            } else {
                large[firstRow * (across + 1) + firstColumn]++
                large[firstRow * (across + 1) + lastColumn + 1]--
                large[(lastRow + 1) * (across + 1) + firstColumn]--
                large[(lastRow + 1) * (across + 1) + lastColumn + 1]++
            }
        }
        var most = 0L
        for (row in 0 until down) {
            for (column in 0 until across) {
                val at = row * (across + 1) + column
                if (column > 0) large[at] += large[at - 1]
                if (row > 0) large[at] += large[at - across - 1]
                if (row > 0 && column > 0) large[at] -= large[at - across - 2]
                most = maxOf(most, large[at] * grid.size * grid.size + small[row * across + column])
            }
        }
        return most
    }

    private companion object {
        /** A triangle in a tile: 12 bytes as it is found, 8 in its bin, up to an eighth more; 16 while it is drawn. */
        const val PAIR_BYTES = 38L

        /** A fragment: 12 bytes as it is found, 12 in its bin, up to an eighth more. */
        const val FRAGMENT_BYTES = 26L

        /** A primitive that is in no batch, while primitives are sorted by their first band. */
        const val ARRIVAL_BYTES = 16L

        /** A primitive in a band: its number, key, columns, spans, and up to 8 tiles; a quarter more. */
        const val MEMBER_BYTES = 84L

        /** The objects that hold the spans of a primitive in a band. */
        const val SPANS_BYTES = 144L

        /** Two columns, in arrays that double. */
        const val SPAN_BYTES = 16L

        /** Bytes of a primitive for the two edges of a span. */
        const val EDGES_BYTES = 64L

        /** A translucent fragment: 12 bytes as it is found, 8 in order; half as much again. */
        const val LAYER_BYTES = 30L

        /** The buffers of a thread for colours. See docs/memory.md for the measurement of the whole. */
        const val THREAD_BYTES = 1L shl 20

        /** A sample of a tile: key, and the end of its layers, and blocks. */
        const val PLACE_BYTES = 16L

        /** Most cells along a side. */
        const val MOST_CELLS = 256
    }
}
