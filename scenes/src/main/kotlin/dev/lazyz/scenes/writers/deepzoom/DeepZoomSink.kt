package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.RowSink
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.RowOrder
import java.io.Closeable
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.ForkJoinPool

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
