package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.UUID
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.function.Function
import org.apache.spark.api.java.function.PairFlatMapFunction
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
            blocks.flatMapToPair(CutBlocks(files))
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
        for (work in blocks.map(WorkOf()).collect()) sum.add(PixelBlock.counters(work)).primitives = work[0]
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

/** Cuts a block, see [CutBlock]. */
internal class CutBlocks(private val files: TileFiles) : PairFlatMapFunction<PixelBlock, TileKey, PixelBlock> {
    override fun call(block: PixelBlock): Iterator<Tuple2<TileKey, PixelBlock>> =
        CutBlock(block, files.width, files.height, files.isOpaque).pieces().iterator()

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** Returns the counters of a block. */
internal class WorkOf : Function<PixelBlock, LongArray> {
    override fun call(block: PixelBlock): LongArray = block.work

    private companion object {
        const val serialVersionUID = 1L
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

    private companion object {
        const val serialVersionUID = 1L
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
