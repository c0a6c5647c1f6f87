package dev.lazyz.conformance.strangers4

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region

/** The tiles of a region, numbered row by row; those at the right and at the bottom may be smaller. */
internal class TileGrid(val region: Region, tileSize: Int) {
    /** Side of a tile: as the options say, but smaller where a picture would have too few tiles for many threads. */
    val side: Int = sideFor(region, tileSize)

    val columns: Int = tiles(region.width, side)
    val rows: Int = tiles(region.height, side)
    val count: Int get() = columns * rows

    fun area(tile: Int): Region {
        val column = region.columnStart + tile % columns * side
        val row = region.rowStart + tile / columns * side
        return Region(column, row, minOf(column + side, region.columnEnd), minOf(row + side, region.rowEnd))
    }

    private companion object {
        const val ENOUGH = 16
        const val LEAST_SIDE = 8

        fun tiles(length: Int, side: Int): Int = (length + side - 1) / side

        fun sideFor(region: Region, tileSize: Int): Int {
            var side = tileSize
            while (side > LEAST_SIDE && tiles(region.width, side) * tiles(region.height, side).toLong() < ENOUGH) {
                side /= 2
            }
            return side
        }
    }
}

/** For each tile the indices of the primitives whose bounds reach into it, one after the other in one array. */
internal class TileBins(frame: Frame, private val grid: TileGrid, private val mistake: Mistake?) {
    private val ends = IntArray(grid.count + 1)
    private val indices: IntArray

    init {
        // Count, then place: a counting sort by tile
        val touching = frame.primitives.indices.filter { frame.primitives[it].touches(grid.region) }
        for (index in touching) forEachTile(frame.primitives[index]) { ends[it + 1]++ }
        for (tile in 0 until grid.count) ends[tile + 1] += ends[tile]
        indices = IntArray(ends[grid.count])
        val places = ends.copyOf()
        for (index in touching) forEachTile(frame.primitives[index]) { indices[places[it]++] = index }
    }

    val bytes: Long get() = 4L * (ends.size + indices.size)

    fun size(tile: Int): Int = ends[tile + 1] - ends[tile]

    /** Returns the submission index of the primitive number [i] of a tile. */
    fun index(tile: Int, i: Int): Int = indices[ends[tile] + i]

    private inline fun forEachTile(primitive: Primitive, action: (Int) -> Unit) {
        val region = grid.region
        val isAbsolute = mistake == Mistake.TILE_BINS_ABSOLUTE
        val left = if (isAbsolute) 0 else region.columnStart
        val top = if (isAbsolute) 0 else region.rowStart
        val firstColumn = (maxOf(primitive.columnStart, region.columnStart) - left) / grid.side
        val lastColumn = (minOf(primitive.columnEnd, region.columnEnd) - 1 - left) / grid.side
        val firstRow = (maxOf(primitive.rowStart, region.rowStart) - top) / grid.side
        val lastRow = (minOf(primitive.rowEnd, region.rowEnd) - 1 - top) / grid.side
        for (row in firstRow..minOf(lastRow, grid.rows - 1)) {
            for (column in firstColumn..minOf(lastColumn, grid.columns - 1)) action(row * grid.columns + column)
        }
    }
}
