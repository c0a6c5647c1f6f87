package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.AlphaChannel
import java.io.IOException
import java.nio.file.Path

/**
 * The rows of the largest level that an interrupted run has finished: those of complete rows of tiles, but at most of
 * all rows of tiles but the last.
 */
internal class FinishedTiles(
    private val folder: Path,
    private val width: Int,
    height: Int,
    private val alpha: AlphaChannel,
) {
    private val across = TileGrid(width)
    private val down = TileGrid(height)
    private val tileRows = (0 until down.tiles).takeWhile { row -> row < down.tiles - 1 && isComplete(row) }

    /** Number of rows. */
    val rows: Int = if (tileRows.isEmpty()) 0 else down.ownEnd(tileRows.last())

    private fun isComplete(row: Int) = (0 until across.tiles).all { TileFile.isWhole(TileRows.tile(folder, it, row)) }

    /**
     * Passes the rows to [take], from the top.
     *
     * @throws IOException if a tile cannot be read
     */
    fun forEach(take: (IntArray) -> Unit) {
        val argb = IntArray(width)
        val part = IntArray(TileGrid.TILE + 2 * TileGrid.OVERLAP)
        for (tileRow in tileRows) {
            val tiles = List(across.tiles) { column ->
                val size = across.end(column) - across.start(column)
                TileReader(TileRows.tile(folder, column, tileRow), size, alpha)
            }
            try {
                for (y in down.start(tileRow) until down.ownEnd(tileRow)) {
                    for ((column, tile) in tiles.withIndex()) {
                        tile.read(part)
                        val start = across.ownStart(column)
                        val from = start - across.start(column)
                        part.copyInto(argb, start, from, from + across.ownEnd(column) - start)
                    }
                    if (y >= down.ownStart(tileRow)) take(argb)
                }
            } finally {
                tiles.forEach { it.close() }
            }
        }
    }
}
