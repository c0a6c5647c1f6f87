package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.filter.BoxPyramid
import scala.Tuple2

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
        for (row in TileKey.tiles(top, bottom, BoxPyramid.side(height, level))) {
            for (column in TileKey.tiles(left, right, BoxPyramid.side(width, level))) {
                val key = TileKey(level, column, row)
                val tile = key.region(width, height)
                val part = Region(
                    maxOf(tile.columnStart, left),
                    maxOf(tile.rowStart, top),
                    minOf(tile.columnEnd, right),
                    minOf(tile.rowEnd, bottom),
                )
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
