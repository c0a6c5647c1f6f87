package dev.lazyz.strategies.tiled.binning

import dev.lazyz.strategies.tiled.raster.TileGrid

/** The tiles that bins are made for: those of the bands [bandStart] until [bandEnd]. Immutable. */
internal class BinArea(private val grid: TileGrid, private val bandStart: Int, bandEnd: Int) {
    /** The samples of these tiles. */
    @JvmField val columnStart: Int = grid.region.columnStart

    @JvmField val columnEnd: Int = grid.region.columnEnd

    @JvmField val rowStart: Int = grid.rowStart(bandStart)

    @JvmField val rowEnd: Int = grid.rowEnd(bandEnd - 1)
    private val columns = grid.columns

    /** Number of bands. */
    val bands: Int = bandEnd - bandStart

    /** Number of tiles. */
    val tiles: Int = bands * columns

    /** The band that is number [number] of these. */
    fun band(number: Int): Int = bandStart + number

    /** The number of a tile. */
    fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    /** The number of the tile that a sample is in. */
    fun tileAt(x: Int, y: Int): Int = tile(grid.bandOf(y), grid.columnOf(x))

    /** Where a sample is in its tile, whose rows have [stride] places. */
    fun placeInTile(x: Int, y: Int, stride: Int): Int = grid.rowInTile(y) * stride + grid.columnInTile(x)
}
