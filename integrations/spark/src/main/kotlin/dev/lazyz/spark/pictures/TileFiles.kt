package dev.lazyz.spark.pictures

import dev.lazyz.Region
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import org.apache.spark.TaskContext

/**
 * The folder into which tasks write the tiles of a pyramid before it is complete. An attempt of a task writes into a
 * folder of its own, and then moves the file to its place; files of several attempts have the same bytes.
 *
 * @param folder the folder, under the same path for the driver and all executors
 * @param isOpaque whether tiles have no alpha channel
 */
internal class TileFiles(
    private val folder: String,
    private val levels: Int,
    val width: Int,
    val height: Int,
    val isOpaque: Boolean,
) : Serializable {
    /** The folder of complete tiles. */
    fun tiles(): Path = Path.of(folder, "tiles")

    private fun level(level: Int): Path = tiles().resolve("${levels - 1 - level}")

    /** Creates the folders of all levels. */
    fun createFolders() {
        for (level in 0 until levels) Files.createDirectories(level(level))
    }

    /** Writes a tile, whose rows are [lines]. */
    fun write(level: Int, column: Int, row: Int, lines: List<IntArray>) {
        val attempt = TaskContext.get()?.taskAttemptId() ?: "driver"
        val own = Files.createDirectories(Path.of(folder, "attempt-$attempt"))
        val name = "${column}_$row.png"
        val columns = lines.first().size
        val none = IntArray(columns)
        val alpha = if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        ImageFiles.write(own.resolve(name), columns, lines.size, ImageFormat.PNG, alpha) { sink ->
            for ((y, line) in lines.withIndex()) sink.row(y, line, none, none)
        }
        Files.move(own.resolve(name), level(level).resolve(name), ATOMIC_MOVE, REPLACE_EXISTING)
    }

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** A tile of a pyramid, on [level], of which 0 is the picture itself. */
internal data class TileKey(val level: Int, val column: Int, val row: Int) : Serializable {
    /** The pixels of its level that the tile shows, in a pyramid of a picture of [width] x [height] pixels. */
    fun region(width: Int, height: Int): Region = Region(
        start(column),
        start(row),
        minOf(end(column), BoxPyramid.side(width, level)),
        minOf(end(row), BoxPyramid.side(height, level)),
    )

    companion object {
        private const val serialVersionUID = 1L

        private fun start(tile: Int) = maxOf(tile * DeepZoomSink.TILE_SIZE - DeepZoomSink.OVERLAP, 0)

        private fun end(tile: Int) = (tile + 1) * DeepZoomSink.TILE_SIZE + DeepZoomSink.OVERLAP

        /** Returns the tiles that show some of the pixels [from] until [until], of [size], of a level. */
        fun tiles(from: Int, until: Int, size: Int): IntRange {
            val last = (size - 1) / DeepZoomSink.TILE_SIZE
            val first = maxOf(from - DeepZoomSink.OVERLAP, 0) / DeepZoomSink.TILE_SIZE
            return first..minOf((until - 1 + DeepZoomSink.OVERLAP) / DeepZoomSink.TILE_SIZE, last)
        }
    }
}
