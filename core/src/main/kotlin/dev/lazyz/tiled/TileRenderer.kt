package dev.lazyz.tiled

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Spans
import dev.lazyz.setup.LateShading
import dev.lazyz.setup.TrapezoidCursor

/** Renders tiles, one after the other: what a thread holds for itself. */
internal class TileRenderer(
    private val frame: Frame,
    private val grid: TileGrid,
    coherence: Coherence,
    private val checkpoint: Checkpoint,
) {
    /** What has been done here. */
    val counters: Counters = Counters()

    private val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()
    private val hasTranslucency = frame.hasTranslucency
    private val keys = TileKeys(grid, frame.raster, counters)
    private val layers = TileLayers(keys, test, counters)
    private val spans = Spans(frame.region)
    private val shading = LateShading(frame, coherence, counters)
    private var cursorBytes = 0L

    /** Bytes held at most. */
    val bytes: Long get() = keys.bytes + layers.bytes + spans.bytes + cursorBytes + shading.peakBytes

    /** Renders the tile [column] of [band]. */
    fun render(band: Band, column: Int) {
        keys.begin(grid.columnStart(column), grid.columnEnd(column), band.rowStart, band.rowEnd)
        layers.begin()
        if (hasTranslucency) {
            // What is opaque hides some of what is not, whatever the order of submission
            drawAll(band, column) { !it.isTranslucent }
            drawAll(band, column) { it.isTranslucent }
            layers.order()
        } else {
            drawAll(band, column) { true }
        }
        shade(band)
    }

    private inline fun drawAll(band: Band, column: Int, isWanted: (Primitive) -> Boolean) {
        band.forEachMember(column) { member ->
            checkpoint.pass()
            val index = band.index(member)
            val primitive = frame.primitives[index]
            if (isWanted(primitive)) draw(band, member, primitive, index)
        }
    }

    private fun draw(band: Band, member: Int, primitive: Primitive, index: Int) {
        val rows = band.spans(member)?.rows(spans, counters, checkpoint)

        // What is behind all that the tile shows is hidden: there is nothing to do but to count its fragments
        val isHidden = band.nearest(member) >= keys.farthest()
        if (rows == null) {
            drawAlone(primitive, index, isHidden)
        } else if (!isHidden) {
            drawShared(rows, primitive, index)
        }
    }

    /** Draws a primitive that this tile is the only one of its band to see. */
    private fun drawAlone(primitive: Primitive, index: Int, isHidden: Boolean) {
        val rowStart = maxOf(primitive.rowStart, keys.rowStart)
        val rowEnd = minOf(primitive.rowEnd, keys.rowEnd)
        val cursor = primitive.cursor(rowStart)
        cursorBytes = maxOf(cursorBytes, if (cursor is TrapezoidCursor) cursor.bytes else CURSOR_BYTES)
        keys.choose(primitive, index)
        for (y in rowStart until rowEnd) {
            cursor.next(spans)
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                if (!isHidden) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
            }
        }
    }

    /** Draws what this tile sees of a primitive whose rows it shares with others. */
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
        if (hasTranslucency && primitive.isTranslucent) {
            layers.add(primitive, index, y, start, end)
        } else {
            keys.draw(y, start, end)
        }
    }

    /** Computes the colours of the tile, now that it is known what is visible. */
    private fun shade(band: Band) {
        val shadedBefore = counters.shadingCalls
        val first = frame.region.columnStart
        for (y in keys.rowStart until keys.rowEnd) {
            checkpoint.pass()
            shading.beginRow()

            // Take the keys apart, and make a colour of each, into the band's rows
            val row = y - keys.rowStart
            val colors = band.argb[row]
            val depths = band.depth[row]
            val indices = band.primitive[row]
            for (x in keys.columnStart until keys.columnEnd) {
                val opaque = keys.at(x, y)
                val key = if (layers.isEmpty) opaque else layers.nearest(keys.place(x, y), opaque)
                val index = test.indexOf(key)
                depths[x - first] = test.depthOf(key)
                indices[x - first] = index
                colors[x - first] = when {
                    index == DepthTest.BACKGROUND -> background
                    key == opaque -> shading.shade(x, y, index)
                    else -> blend(x, y, opaque)
                }
            }
        }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    /** Returns the colour of a sample at which a translucent primitive is in front of what is [opaque]. */
    private fun blend(x: Int, y: Int, opaque: Long): Int {
        val backdrop = if (test.indexOf(opaque) == DepthTest.BACKGROUND) null else opaque
        return layers.blend(keys.place(x, y), backdrop, frame.raster.background) { key ->
            shading.shaded(x, y, test.indexOf(key), frame.primitives[test.indexOf(key)])
        }
    }

    private companion object {
        /** A cursor that evaluates each row on its own; what a user's own holds is not known. */
        const val CURSOR_BYTES = 24L
    }
}
