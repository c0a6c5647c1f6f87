package dev.lazyz.strategies.tiled.raster

import dev.lazyz.Region

/**
 * A region divided into tiles of [size] x [size] samples; the size is a power of two. Tiles at the right and lower
 * border may be smaller. Immutable.
 *
 * A row of tiles is called a band; *row* always refers to a row of samples.
 */
internal class TileGrid(val region: Region, val size: Int) {
    private val shift = Integer.numberOfTrailingZeros(size)
    private val columnStart = region.columnStart
    private val columnEnd = region.columnEnd
    private val rowStart = region.rowStart
    private val rowEnd = region.rowEnd

    /** Number of tiles in a band. */
    val columns: Int = (region.width - 1) / size + 1

    /** Number of bands. */
    val bands: Int = (region.height - 1) / size + 1

    /** Columns of samples in the widest tile. */
    val tileWidth: Int = minOf(size, region.width)

    /** Rows of samples in the highest tile. */
    val tileHeight: Int = minOf(size, region.height)

    /** The band that contains row [y] of the region. */
    fun bandOf(y: Int): Int = (y - rowStart) shr shift

    /** The column of tiles that contains column [x] of the region. */
    fun columnOf(x: Int): Int = (x - columnStart) shr shift

    /** The position of row [y] of the region within its tile. */
    fun rowInTile(y: Int): Int = (y - rowStart) and (size - 1)

    /** The position of column [x] of the region within its tile. */
    fun columnInTile(x: Int): Int = (x - columnStart) and (size - 1)

    /** First row of samples of a band. */
    fun rowStart(band: Int): Int = rowStart + band * size

    /** The row after the last of a band. */
    fun rowEnd(band: Int): Int = minOf(rowEnd, rowStart(band) + size)

    /** First column of samples of a tile. */
    fun columnStart(column: Int): Int = columnStart + column * size

    /** The column after the last of a tile. */
    fun columnEnd(column: Int): Int = minOf(columnEnd, columnStart(column) + size)
}
