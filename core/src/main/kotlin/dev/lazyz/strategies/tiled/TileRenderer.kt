package dev.lazyz.strategies.tiled

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.raster.bytes
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatchWith
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.binning.BandSpans
import dev.lazyz.strategies.tiled.binning.NearToFar
import dev.lazyz.strategies.tiled.binning.TriangleBins
import dev.lazyz.strategies.tiled.binning.opaqueTriangle
import dev.lazyz.strategies.tiled.raster.FineRaster
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer
import dev.lazyz.strategies.tiled.resolve.TileLayers
import dev.lazyz.strategies.tiled.resolve.TilePixels
import dev.lazyz.strategies.tiled.resolve.TileSamples

/**
 * Renders tiles, one after the other. Holds the working memory of one thread.
 *
 * @param side how many samples wide and high a pixel of the result is
 */
internal class TileRenderer(
    private val frame: Frame,
    private val grid: TileGrid,
    coherence: Coherence,
    kernels: Kernels,
    private val checkpoint: Checkpoint,
    side: Int,
) {
    /** Counters of the tiles rendered here. */
    val counters: Counters.Builder = Counters.Builder()

    private val test = frame.raster.depthTest
    private val content = frame.content
    private val hasTranslucency = content.hasTranslucency
    private val keys = VisibilityBuffer(grid, frame.raster, counters)
    private val layers = TileLayers(keys, test, counters)
    private val spans = frame.region.spans()
    private val drawing = FineRaster(keys, kernels.blocks(), counters)
    private val batches = EarlyZDrawing(content, test, keys, drawing, checkpoint)
    private val forms = TriangleForms(test)
    private val shading = if (side == 1) {
        TileSamples(frame, keys, layers, coherence, kernels.fragments(), counters, checkpoint)
    } else {
        TilePixels(frame, keys, layers, kernels.fragments(), counters, checkpoint, side)
    }
    private var cursorBytes = 0L

    /** Peak number of bytes held. */
    val bytes: Long get() = keys.bytes + layers.bytes + spans.bytes + batches.bytes + cursorBytes + shading.bytes

    /** Renders the tile [column] of [band]. */
    fun render(band: Band, column: Int) {
        if (band.isEmpty(column)) return shading.clear(band, grid.columnStart(column), grid.columnEnd(column))
        keys.begin(grid.columnStart(column), grid.columnEnd(column), band.rowStart, band.rowEnd)
        layers.begin()
        band.bins?.let { batches.draw(it, band.number, column) }
        if (hasTranslucency) {
            // Opaque primitives hide some of the translucent ones, regardless of the order of submission
            drawAll(band, column) { !it.isTranslucent }
            drawAll(band, column) { it.isTranslucent }
            layers.order(checkpoint)
        } else {
            drawAll(band, column) { true }
        }
        shading.shade(band, band.isFine(column))
    }

    private inline fun drawAll(band: Band, column: Int, isWanted: (Primitive) -> Boolean) {
        band.forEachMember(column) { member ->
            checkpoint.pass()
            val primitive = content.singles[band.single(member)]
            if (isWanted(primitive)) draw(band, member, primitive, content.index(band.single(member)))
        }
    }

    private fun draw(band: Band, member: Int, primitive: Primitive, index: Int) {
        // A primitive behind everything visible in the tile is hidden
        if (band.nearest(member) >= keys.farthest()) return
        val shared = band.spans(member)
        val triangle = primitive.opaqueTriangle()
        when {
            shared != null -> drawShared(shared.rows(spans, counters, checkpoint), primitive, index)
            triangle != null -> drawTriangle(triangle, index)
            else -> drawUnshared(primitive, index)
        }
    }

    /** Draws the part of a triangle within this tile. */
    private fun drawTriangle(primitive: PlanarPrimitive, index: Int) {
        val t = primitive.reference
        if (!drawing.begin(t.x0, t.y0, t.x1, t.y1, t.x2, t.y2)) return
        forms.depth(index, primitive.depthForm, primitive.leastDepth, primitive.greatestDepth)
        forms.moveTo(keys.columnStart, keys.rowStart)
        if (t.size > 0) drawing.draw(forms, t.x0, t.y0, t.x1, t.y1, t.x2, t.y2)
    }

    /** Draws a primitive that reaches only this tile of its band. */
    private fun drawUnshared(primitive: Primitive, index: Int) {
        val rowStart = maxOf(primitive.rowStart, keys.rowStart)
        val rowEnd = minOf(primitive.rowEnd, keys.rowEnd)
        val cursor = primitive.cursor(rowStart)
        cursorBytes = maxOf(cursorBytes, cursor.bytes)
        keys.choose(primitive, index)
        for (y in rowStart until rowEnd) {
            checkpoint.pass()
            cursor.next(spans)
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                drawSpan(primitive, index, y, spans.start(i), spans.end(i))
            }
        }
    }

    /** Draws the part of a primitive within this tile; other tiles share the primitive's rows. */
    private fun drawShared(rows: BandSpans.Rows, primitive: Primitive, index: Int) {
        keys.choose(primitive, index)
        for (row in 0 until rows.count) {
            var at = rows.firstBehind(row, keys.columnStart)
            val end = rows.end(row)
            while (at < end && rows.start(at) < keys.columnEnd) {
                drawSpan(primitive, index, rows.first + row, rows.start(at), rows.until(at))
                at += 2
            }
        }
    }

    private fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        if (isTranslucent(primitive)) {
            layers.add(primitive, index, y, start, end)
        } else {
            keys.draw(y, start, end)
        }
    }

    private fun isTranslucent(primitive: Primitive): Boolean = hasTranslucency && primitive.isTranslucent
}

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
