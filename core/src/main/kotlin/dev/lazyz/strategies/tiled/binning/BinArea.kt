package dev.lazyz.strategies.tiled.binning

import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * The tiles of a set of bins: those of the bands [bandStart] until [bandEnd]. Immutable.
 *
 * @throws IllegalArgumentException if these tiles have more than 2^32 samples
 */
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

    private val stride = VisibilityBuffer.stride(grid)
    private val placeBits = Int.SIZE_BITS - (stride * grid.tileHeight - 1).countLeadingZeroBits()

    init {
        require(tiles.toLong() shl placeBits <= 1L shl Int.SIZE_BITS) {
            "a row of $columns tiles of ${grid.size} x ${grid.size} samples is too long; use smaller tiles (tileSize)"
        }
    }

    /** Converts an index within these bands to a band number. */
    fun band(number: Int): Int = bandStart + number

    /** The number of a tile. */
    fun tile(band: Int, column: Int): Int = (band - bandStart) * columns + column

    /** The tile of a sample and its place in the tile, in one number of 32 bits: see [tileOf] and [placeOf]. */
    fun locate(x: Int, y: Int): Int =
        tile(grid.bandOf(y), grid.columnOf(x)) shl placeBits or grid.rowInTile(y) * stride + grid.columnInTile(x)

    /** The tile of a sample that is at [location]. */
    fun tileOf(location: Int): Int = location ushr placeBits

    /** The place in its tile of a sample that is at [location]. */
    fun placeOf(location: Int): Int = location and (1 shl placeBits) - 1
}
