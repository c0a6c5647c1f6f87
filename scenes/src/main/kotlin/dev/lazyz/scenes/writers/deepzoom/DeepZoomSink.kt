package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.RowSink
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.RowOrder
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.Closeable
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ForkJoinPool
import java.util.stream.IntStream

/**
 * Writes the tiles of a Deep Zoom pyramid as rows arrive: PNG files, sRGB, 8 bits per channel.
 *
 * The pyramid has a folder for each level, `0` for a single pixel, up to the picture itself. Each level is half as
 * large as the next one: its pixels are exact means of light, see [BoxPyramid]. The tile in column c and row r is the
 * file `c_r.png`. It has 254 x 254 pixels of its own, and one row or column of each neighbour, so that a viewer that
 * enlarges tiles shows no seams; tiles at the edges are smaller.
 *
 * Tiles are compressed in parallel on the threads of the common pool, and appended to their files in blocks of rows.
 * The bytes are the same for any number of threads. Memory: 4 MiB for each level of 4096 or more columns, about as much
 * for all smaller ones, and about 60 bytes a column; so 25 MiB for 100,000 columns, whatever the height. Call [close]
 * after the last row. Not thread safe.
 *
 * This class writes the folder of tiles only. [DeepZoomFiles] also writes the descriptor, and leaves no partial files.
 *
 * Source: the Deep Zoom file format of Microsoft Silverlight, as OpenSeadragon reads it.
 *
 * @param folder the folder for the levels; created if it does not exist. Tiles in it that are complete are left as they
 *   are
 * @param width number of columns; of a wider row, the first ones are written: arrays may be longer than rows, so that a
 *   sink does not see how wide a row is
 * @param height number of rows
 * @param alpha whether tiles have an alpha channel; without one, all pixels count as opaque
 * @throws IllegalArgumentException if a side is not in the range of [BoxPyramid]
 * @throws IOException if a folder cannot be created
 */
public class DeepZoomSink
@JvmOverloads
@Throws(IOException::class)
constructor(
    private val folder: Path,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel = AlphaChannel.KEEP,
) : RowSink,
    Closeable {
    private var order = RowOrder(width, height)
    private val pyramid = BoxPyramid(width, height) { level, _, argb -> levels[level].add(argb) }

    /** The levels, from the largest. */
    private val levels: List<TileRows> = List(pyramid.levels) { level ->
        TileRows(folder(level), BoxPyramid.side(width, level), BoxPyramid.side(height, level), alpha)
    }

    private fun folder(level: Int): Path = folder.resolve("${pyramid.levels - 1 - level}")

    /**
     * Writes row [y]; depth and primitive are ignored.
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row (the first one may have any number from
     *   0 on), or the row has fewer than [width] columns
     * @throws IOException if a tile cannot be written
     */
    @Throws(IOException::class)
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        order.take(y, argb)

        // All levels show the picture that its own tiles show
        if (alpha == AlphaChannel.DROP) for (x in 0 until width) argb[x] = argb[x] or OPAQUE
        pyramid.add(argb)
    }

    /**
     * Takes the first rows from the tiles that another sink has finished. Call it before the first row.
     *
     * @return how many rows these were
     * @throws IOException if a tile cannot be read
     */
    internal fun resume(): Int {
        val finished = FinishedTiles(folder(0), width, height, alpha)
        finished.forEach { pyramid.add(it) }
        order = RowOrder(width, height - finished.rows)
        return finished.rows
    }

    /**
     * Ends the pyramid. Closing again does nothing.
     *
     * @throws IOException if rows are missing
     */
    @Throws(IOException::class)
    override fun close(): Unit = order.requireComplete()

    override fun toString(): String = "DeepZoomSink($folder, $width x $height, $alpha, $order)"

    public companion object {
        /** Width and height of a tile without what it shares with its neighbours, in pixels. */
        public const val TILE_SIZE: Int = LevelTiles.TILE

        /** Width of what a tile shows of each of its neighbours, in pixels. */
        public const val OVERLAP: Int = LevelTiles.OVERLAP

        private const val OPAQUE = 0xFF shl 24

        /** A part of a tile that is being compressed: its colours, filtered bytes and compressed bytes. */
        private const val PART_BYTES = 2L shl 20

        /** Bytes of a column of the picture in [BoxPyramid]. */
        private const val COLUMN_BYTES = 40L

        /** The state of a [TileReader]. */
        private const val READER_BYTES = 48L shl 10

        /** Returns how many bytes a sink for so many columns and rows holds at most. */
        @JvmStatic
        public fun memory(width: Int, height: Int): Long {
            val levels = (0 until BoxPyramid.levels(width, height)).sumOf { level ->
                TileRows.bytes(BoxPyramid.side(width, level), BoxPyramid.side(height, level))
            }
            return levels + COLUMN_BYTES * width + PART_BYTES * (1 + ForkJoinPool.getCommonPoolParallelism())
        }

        /** Returns how many bytes a sink holds in addition while it reads the tiles of an interrupted rendering. */
        @JvmStatic
        public fun resumingMemory(width: Int): Long = READER_BYTES * LevelTiles(width).tiles
    }
}

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
    private val across = LevelTiles(width)
    private val down = LevelTiles(height)
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
        val part = IntArray(LevelTiles.TILE + 2 * LevelTiles.OVERLAP)
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
