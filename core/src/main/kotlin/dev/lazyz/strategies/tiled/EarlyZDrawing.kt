package dev.lazyz.strategies.tiled

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.FrameContent
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatchWith
import dev.lazyz.strategies.tiled.binning.NearToFar
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.raster.FineRaster
import dev.lazyz.strategies.tiled.raster.TriangleForms
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * Early z: draws the batches' triangles of one tile from near to far, so that hidden triangles can be rejected before
 * they are drawn. [FineRaster] rejects hidden blocks. Belongs to one thread; reused for each tile.
 */
internal class EarlyZDrawing(
    private val content: FrameContent,
    private val test: DepthTest,
    private val keys: VisibilityBuffer,
    private val drawing: FineRaster,
    private val checkpoint: Checkpoint,
) {
    private val forms = TriangleForms(test)

    /** The triangles' nearest keys. */
    private val triangles = NearToFar()

    /** Bytes held. */
    val bytes: Long get() = triangles.bytes

    /** Draws the triangles that [bins] holds for the tile [column] of band number [band]. */
    fun draw(bins: TriangleBins, band: Int, column: Int) {
        // The fragments of small triangles are already known
        drawing.count(bins.fragmentCount(band, column), bins.lower(band, column, keys.keys))
        bins.copyTriangles(band, column, triangles.begin(bins.triangleCount(band, column)))
        triangles.sort()
        for (i in 0 until triangles.count) {
            checkpoint.pass()
            val nearest = triangles[i]
            if (nearest >= keys.farthest()) continue
            val index = test.indexOf(nearest)
            val batch = batch(index)
            draw(batch, index - batch.first)
        }
    }

    /** The batch of a triangle, in most cases the same as for the previous triangle. */
    private fun batch(index: Int): TriangleBatch {
        val last = lastBatch
        if (last != null && index >= last.first && index < last.first + last.count) return last
        return content.triangleBatchWith(index).also { lastBatch = it }
    }

    private var lastBatch: TriangleBatch? = null

    private fun draw(batch: TriangleBatch, triangle: Int) {
        batch.vertices(triangle) { ax, ay, bx, by, cx, cy ->
            if (!drawing.begin(ax, ay, bx, by, cx, cy)) return
            forms.depth(batch, triangle)
            forms.moveTo(keys.columnStart, keys.rowStart)
            drawing.draw(forms, ax, ay, bx, by, cx, cy)
        }
    }
}
