package dev.lazyz.strategies.tiled.binning

import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.setup.planar.triangleBatchWith
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms

/**
 * What the triangles that reach many tiles bring to those of some bands, one part of [TriangleBins]. Belongs to one thread at
 * a time.
 *
 * They are taken from near to far, and of what lies behind a triangle that covers all samples of a tile the tile hears
 * nothing: so bins grow with what may be seen, not with depth complexity.
 */
internal class WideTriangles(
    private val content: FrameContent,
    private val area: BinArea,
    grid: TileGrid,
    private val test: DepthTest,
    pool: ArrayPool,
    private val ends: BinEnds,
) {
    private val forms = TriangleForms(test)
    private val tiles = TriangleTiles(area, grid)

    /** Nearest key of each triangle, and a tile that it reaches. */
    private val found = KeyedPlaces(pool)

    /** Bytes held, at most. */
    val bytes: Long get() = found.bytes + Long.SIZE_BYTES * area.tiles.toLong()

    /** Notes all triangles for the tiles of part number [part] of [parts]. */
    fun enter(triangles: NearToFar, part: Int, parts: Int) {
        val bandStart = area.bands * part / parts
        val bandEnd = area.bands * (part + 1) / parts

        // Of each tile a key that nothing is behind which is to be seen
        val farthest = LongArray(area.tiles) { Long.MAX_VALUE }
        for (i in 0 until triangles.count) {
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

    /** Puts the triangles where they belong; nothing is left here. */
    fun distribute(keys: LongArray) {
        found.forEach { nearest, tile -> keys[ends.next(ROW, tile)] = nearest }
        found.release()
    }

    companion object {
        /** Tiles from which on a triangle is wide: it may cover some wholly, and hiding it is worth while. */
        const val TILES: Int = 8

        /** The row of [BinEnds] for these triangles, of which each tile gets its own from one part only. */
        const val ROW: Int = 0
    }
}
