package dev.lazyz.scenes.writers.deepzoom

/**
 * How columns, or rows, of a level are divided into tiles. Neighbours share [OVERLAP] pixels on each side of the border
 * between them.
 *
 * @property size number of columns or rows of the level
 */
internal class TileGrid(private val size: Int) {
    /** Number of tiles. */
    val tiles: Int = (size + TILE - 1) / TILE

    /** The first column or row of [tile]. */
    fun start(tile: Int): Int = maxOf(tile * TILE - OVERLAP, 0)

    /** The end of the columns or rows of [tile]. */
    fun end(tile: Int): Int = minOf((tile + 1) * TILE + OVERLAP, size)

    /** The first column or row of [tile] that no tile before it has as its own. */
    fun ownStart(tile: Int): Int = tile * TILE

    /** The end of those columns or rows. */
    fun ownEnd(tile: Int): Int = minOf((tile + 1) * TILE, size)

    companion object {
        /** With what they share, tiles are 256 pixels wide and high. */
        const val TILE: Int = 254
        const val OVERLAP: Int = 1
    }
}
