package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink
import java.io.IOException
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.UUID
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import org.apache.spark.TaskContext
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.function.VoidFunction
import org.apache.spark.storage.StorageLevel
import scala.Tuple2

/**
 * Writes a Deep Zoom pyramid. Tasks render blocks, make the smaller levels of them, and cut all into tiles; Spark
 * brings the pieces of each tile together, and a task writes it. A block begins at a multiple of 1024 rows and columns,
 * so each pixel of the levels down to 1/1024 belongs to one block.
 *
 * @param path the descriptor
 */
internal class PyramidJob(
    private val path: Path,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel,
) {
    private val levels = BoxPyramid.levels(width, height)

    /** Renders with [parts], and writes all files. */
    @OptIn(ExperimentalPathApi::class)
    fun write(parts: SortFirst): Counters {
        require("$path".endsWith(".${DeepZoomFiles.EXTENSION}", ignoreCase = true)) {
            "cannot write $path: the name of a Deep Zoom pyramid must end in .${DeepZoomFiles.EXTENSION}"
        }
        val place = path.toAbsolutePath().parent
        if (!Files.isDirectory(place)) throw IOException("cannot write $path: there is no folder $place; create it")
        val staging = place.resolve(".${path.fileName}.${UUID.randomUUID()}")
        val files = TileFiles("$staging", levels, width, height, alpha == AlphaChannel.DROP)
        val blocks = parts.blocks(regions()).persist(StorageLevel.DISK_ONLY())
        try {
            files.createFolders()
            blocks.flatMapToPair { CutBlock(it, files.width, files.height, files.isOpaque).pieces().iterator() }
                .groupByKey()
                .foreach(WriteTiles(files))
            val counters = counters(blocks)
            writeTop(blocks, files)
            DeepZoomFiles.publish(path, files.tiles(), width, height)
            return counters
        } finally {
            blocks.unpersist(false)
            staging.deleteRecursively()
        }
    }

    private fun regions(): List<Region> = (0 until height step CutBlock.ROWS).flatMap { top ->
        (0 until width step COLUMNS).map { left ->
            Region(left, top, minOf(left + COLUMNS, width), minOf(top + CutBlock.ROWS, height))
        }
    }

    private fun counters(blocks: JavaRDD<PixelBlock>): Counters {
        val sum = Counters.Builder()
        for (work in blocks.map { it.work }.collect()) sum.add(PixelBlock.counters(work)).primitives = work[0]
        return sum.build()
    }

    /** Writes the levels that several blocks have a part in, one tile each. */
    private fun writeTop(blocks: JavaRDD<PixelBlock>, files: TileFiles) {
        val first = CutBlock.LEVELS
        if (levels <= first) return
        val rows = (first until levels).associateWith { ArrayList<IntArray>() }
        val pyramid = BoxPyramid(width, height) { level, _, argb ->
            if (level >= first) rows.getValue(level).add(argb.copyOf(BoxPyramid.side(width, level)))
        }
        val across = (width + COLUMNS - 1) / COLUMNS
        for (band in blocks.toLocalIterator().asSequence().chunked(across)) {
            val readers = band.map { it.reader() to it.region.columnStart }
            val row = IntArray(width)
            for (y in band.first().rowStart until band.first().rowEnd) {
                for ((reader, start) in readers) reader.next().let { it.copyInto(row, start) }
                if (files.isOpaque) for (x in row.indices) row[x] = row[x] or CutBlock.OPAQUE
                pyramid.add(row)
            }
        }
        for ((level, lines) in rows) files.write(level, 0, 0, lines)
    }

    private companion object {
        const val COLUMNS = 4 * CutBlock.ROWS
    }
}

/** Puts the pieces of a tile together, and writes it. */
internal class WriteTiles(private val files: TileFiles) : VoidFunction<Tuple2<TileKey, Iterable<PixelBlock>>> {
    override fun call(tile: Tuple2<TileKey, Iterable<PixelBlock>>) {
        val key = tile._1()
        val region = key.region(files.width, files.height)
        val lines = List(region.height) { IntArray(region.width) }
        for (piece in tile._2()) {
            val start = piece.region.columnStart - region.columnStart
            piece.forEachRow { y, row -> row.copyInto(lines[y - region.rowStart], start) }
        }
        files.write(key.level, key.column, key.row, lines)
    }
}

/**
 * Makes the smaller levels of a rendered block, and cuts all into pieces of tiles. Used once.
 *
 * @param width columns of the picture
 * @param height rows of the picture
 * @param isOpaque whether pixels lose their alpha
 */
internal class CutBlock(
    private val block: PixelBlock,
    private val width: Int,
    private val height: Int,
    private val isOpaque: Boolean,
) {
    private val region = block.region

    /** The rows of the block on each level. */
    private val rows = List(minOf(LEVELS, BoxPyramid.levels(width, height))) { ArrayList<IntArray>() }

    /** Returns the pieces of all tiles. */
    fun pieces(): Sequence<Tuple2<TileKey, PixelBlock>> {
        val pyramid = BoxPyramid(region.width, region.height) { level, _, argb ->
            if (level < rows.size) rows[level].add(argb.copyOf(BoxPyramid.side(region.width, level)))
        }
        block.forEachRow { _, argb ->
            if (isOpaque) for (x in argb.indices) argb[x] = argb[x] or OPAQUE
            pyramid.add(argb)
        }

        // A small block at an edge is one pixel before the picture is
        for (level in pyramid.levels until rows.size) rows[level].add(rows[level - 1].single())
        return rows.indices.asSequence().flatMap(::cut)
    }

    private fun cut(level: Int): Sequence<Tuple2<TileKey, PixelBlock>> = sequence {
        val left = region.columnStart shr level
        val top = region.rowStart shr level
        val right = left + rows[level].first().size
        val bottom = top + rows[level].size
        val block = Region(left, top, right, bottom)
        for (row in TileKey.tiles(top, bottom, BoxPyramid.side(height, level))) {
            for (column in TileKey.tiles(left, right, BoxPyramid.side(width, level))) {
                val key = TileKey(level, column, row)
                val part = checkNotNull(key.region(width, height).intersect(block))
                val piece = PixelBlock.Builder(part, planes = 1)
                for (y in part.rowStart until part.rowEnd) piece.add(rows[level][y - top], part.columnStart - left)
                yield(Tuple2(key, piece.build(Counters.NONE)))
            }
        }
    }

    companion object {
        /** Rows of a block. */
        const val ROWS: Int = 1024

        /** Levels on which each pixel belongs to one block: down to 1/[ROWS] of the size. */
        const val LEVELS: Int = 11

        const val OPAQUE: Int = 0xFF shl 24
    }
}

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
