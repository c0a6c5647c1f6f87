package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.stream.IntStream

/**
 * Writes the tiles of one level into [folder], while its rows arrive from the top. Tiles that are there already,
 * and whole, are left as they are.
 *
 * Rows are collected until they are about [BLOCK_PIXELS] pixels, or the tiles are complete; then each tile's part of
 * them is compressed, on the threads of the common pool, and appended to the tile's file. How rows are divided depends
 * on the size of the level only. So the bytes are the same for any number of threads.
 */
internal class TileRows(
    private val folder: Path,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel,
) {
    private val across = LevelTiles(width)
    private val down = LevelTiles(height)
    private val rowsOfBlock = rowsOfBlock(width)

    /** The row above, and then the rows that are not written. */
    private val argb = IntArray((1 + minOf(rowsOfBlock, height)) * width)
    private var rows = 0

    /** The last rows of the level, by their number modulo the length: tiles begin with those of the tiles above. */
    private val last = Array(minOf(LAST_ROWS, height)) { IntArray(width) }

    /** The tiles that are being written, by column; null for those that are there already. */
    private var tiles = emptyList<TileFile?>()
    private var tileRow = 0
    private var next = 0

    init {
        Files.createDirectories(folder)
        begin()
    }

    /** Adds the next row. */
    fun add(row: IntArray) {
        val y = next++
        row.copyInto(last[y % last.size], 0, 0, width)
        put(y)
        while (y + 1 == down.end(tileRow) && ++tileRow < down.tiles) {
            begin()
            for (shared in down.start(tileRow)..y) put(shared)
        }
    }

    private fun begin() {
        argb.fill(0, 0, width)
        tiles = List(across.tiles) { column ->
            val path = tile(folder, column, tileRow)
            val size = across.end(column) - across.start(column)
            if (TileFile.isWhole(path)) null else TileFile(path, size, down.end(tileRow) - down.start(tileRow), alpha)
        }
    }

    /** Adds row [y], which is one of the last, to the current tiles. */
    private fun put(y: Int) {
        rows++
        last[y % last.size].copyInto(argb, rows * width)
        if (rows == rowsOfBlock || y + 1 == down.end(tileRow)) flush()
    }

    private fun flush() {
        try {
            IntStream.range(0, tiles.size).parallel().forEach { column -> tiles[column]?.append(part(column), rows) }
        } catch (e: UncheckedIOException) {
            // On a signal, temporary folders are deleted while rows still arrive
            if (TemporaryFile.isExiting) Thread.sleep(Long.MAX_VALUE)
            throw e.cause ?: e
        }
        argb.copyInto(argb, 0, rows * width, (rows + 1) * width)
        rows = 0
    }

    /** Returns the columns of the tile in column [column]. */
    private fun part(column: Int): IntArray {
        val start = across.start(column)
        val size = across.end(column) - start
        val part = IntArray((1 + rows) * size)
        for (row in 0..rows) argb.copyInto(part, row * size, row * width + start, row * width + start + size)
        return part
    }

    companion object {
        /** 4 MiB a level: so small that all levels fit into little memory, so large that tiles compress well. */
        private const val BLOCK_PIXELS = 1 shl 20

        private const val LAST_ROWS = 2 * LevelTiles.OVERLAP

        /** The state of a tile that is being written. */
        private const val TILE_BYTES = 512L

        private fun rowsOfBlock(width: Int): Int =
            (BLOCK_PIXELS / width).coerceIn(1, LevelTiles.TILE + 2 * LevelTiles.OVERLAP)

        /** Bytes held for a level, without those of threads that compress tiles. */
        fun bytes(width: Int, height: Int): Long {
            val rows = 1L + minOf(rowsOfBlock(width), height) + minOf(LAST_ROWS, height)
            return Int.SIZE_BYTES * rows * width + TILE_BYTES * LevelTiles(width).tiles
        }

        /** Returns the file of the tile in [column] and [row] of the level that is in [folder]. */
        fun tile(folder: Path, column: Int, row: Int): Path = folder.resolve("${column}_$row.png")
    }
}
