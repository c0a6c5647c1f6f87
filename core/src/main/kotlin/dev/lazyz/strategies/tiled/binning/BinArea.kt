package dev.lazyz.strategies.tiled.binning

import dev.lazyz.strategies.tiled.raster.TileGrid

/** The tiles of a set of bins: those of the bands [bandStart] until [bandEnd]. Immutable. */
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

    /** Converts an index within these bands to a band number. */
    fun band(number: Int): Int = bandStart + number

    /** The number of a tile. */
    fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    /** The number of the tile that contains a sample. */
    fun tileAt(x: Int, y: Int): Int = tile(grid.bandOf(y), grid.columnOf(x))

    /** The place of a sample within its tile, whose rows have [stride] places. */
    fun placeInTile(x: Int, y: Int, stride: Int): Int = grid.rowInTile(y) * stride + grid.columnInTile(x)
}
