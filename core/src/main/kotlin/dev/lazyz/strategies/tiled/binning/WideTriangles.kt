package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.setup.triangleBatchWith
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms

/**
 * The triangles that reach many tiles, sorted into the tiles of some bands: one part of [TriangleBins]. Belongs to one
 * thread at a time.
 *
 * Triangles are processed from near to far. If a triangle covers all samples of a tile, the triangles behind it are not
 * entered for that tile. The size of bins thus grows with what may be visible, not with depth complexity.
 */
internal class WideTriangles(
    private val content: FrameContent,
    private val area: BinArea,
    grid: TileGrid,
    private val test: DepthTest,
    pool: ArrayPool,
    private val ends: BinBounds,
) {
    private val forms = TriangleForms(test)
    private val tiles = CoarseRaster(area, grid)

    /** Nearest key of each triangle, and a tile that it reaches. */
    private val found = KeyedPlaces(pool)

    /** Peak number of bytes held. */
    val bytes: Long get() = found.bytes + Long.SIZE_BYTES * area.tiles.toLong()

    /** Records all triangles for the tiles of part number [part] of [parts]. Passes [checkpoint] for each. */
    fun enter(triangles: NearToFar, part: Int, parts: Int, checkpoint: Checkpoint) {
        val bandStart = area.bands * part / parts
        val bandEnd = area.bands * (part + 1) / parts

        // For each tile, an upper bound of the keys that can be visible
        val farthest = LongArray(area.tiles) { Long.MAX_VALUE }
        for (i in 0 until triangles.count) {
            checkpoint.pass()
            val nearest = triangles[i]
            val index = test.indexOf(nearest)
            val batch = content.triangleBatchWith(index)
            if (tiles.begin(batch, index - batch.first, bandStart, bandEnd) == 0) continue
            val own = forms.farthest(batch, index - batch.first)
            tiles.forEach({ nearest >= farthest[it] }) { tile, isCovered ->
                ends.count(ROW, tile)
                found.add(nearest, tile)
                if (isCovered) farthest[tile] = minOf(farthest[tile], own)
            }
        }
    }

    /** Moves the triangles to their bins; nothing is left here. */
    fun distribute(keys: LongArray) {
        found.forEach { nearest, tile -> keys[ends.next(ROW, tile)] = nearest }
        found.release()
    }

    companion object {
        /**
         * Number of tiles from which on a triangle is wide: it may cover some completely, and rejecting others is
         * worthwhile.
         */
        const val TILES: Int = 8

        /** The row of [BinBounds] for these triangles; each tile receives them from a single part. */
        const val ROW: Int = 0
    }
}
