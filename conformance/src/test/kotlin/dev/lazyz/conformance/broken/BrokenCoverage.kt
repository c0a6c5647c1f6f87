package dev.lazyz.conformance.broken

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.changed.Cutting
import dev.lazyz.conformance.cases.changed.Recovered

/** Renderers that are correct except for coverage. */
object BrokenCoverage {
    fun spansStartLate() = misreading("spans-start-late") { _, from, to ->
        for (i in 0 until from.count) if (from.start(i) + 1 < from.end(i)) to.add(from.start(i) + 1, from.end(i))
    }

    fun sharedEdgeTwice() = drawing("shared-edge-twice") { frame ->
        frame.misread { _, from, to ->
            for (i in 0 until from.count) {
                val next = if (i + 1 < from.count) from.start(i + 1) else frame.raster.width
                to.add(from.start(i), minOf(from.end(i) + 1, next))
            }
        }
    }

    fun firstSpanOnly() = misreading("first-span-only") { _, from, to ->
        if (from.count > 0) to.add(from.start(0), from.end(0))
    }

    fun singleSamplesLost() = misreading("single-samples-lost") { _, from, to ->
        for (i in 0 until from.count) if (from.start(i) + 1 < from.end(i)) to.add(from.start(i), from.end(i))
    }

    fun windingInverted() = misreading("winding-inverted") { _, from, to ->
        if (from.count == 1) to.add(from.start(0), from.end(0))
        for (i in 0 until from.count - 1) to.add(from.end(i), from.start(i + 1))
    }

    fun tileColumnMissing() = misreading("tile-column-missing") { _, from, to ->
        for (i in 0 until from.count) {
            for (x in from.start(i) until from.end(i)) {
                if (x % TILE < TILE - 1) {
                    to.add(x, x + 1)
                }
            }
        }
    }

    fun tileRowMissing() = misreading("tile-row-missing") { y, from, to ->
        if (y % TILE < TILE - 1) for (i in 0 until from.count) to.add(from.start(i), from.end(i))
    }

    fun lateActivation() = drawing("late-activation") { frame ->
        Frame(frame.raster, frame.primitives.map { Cutting(it, ALL, it.rowStart + 1..<Raster.MAX_SIDE) }, frame.region)
    }

    fun earlyRetirement() = drawing("early-retirement") { frame ->
        Frame(frame.raster, frame.primitives.map { Cutting(it, ALL, 0..<it.rowEnd - 1) }, frame.region)
    }

    fun staleActiveEdge() = drawing("stale-active-edge") { frame ->
        Frame(frame.raster, frame.primitives.map { StaleRow(it, frame.raster.height) }, frame.region)
    }

    /** Repeats the coverage of the last row in the row after it. */
    private class StaleRow(whole: Primitive, private val height: Int) : Recovered(whole) {
        private val isLonger get() = rowStart < whole.rowEnd && whole.rowEnd < height
        override val rowEnd: Int get() = whole.rowEnd + if (isLonger) 1 else 0

        override fun spans(y: Int, spans: Spans) = whole.spans(stale(y), spans)

        override fun depth(x: Int, y: Int): Int = whole.depth(x, stale(y))

        override val depthForm get() = null

        private fun stale(y: Int) = if (isLonger && y == whole.rowEnd) y - 1 else y
    }

    private class Reading(whole: Primitive, private val how: (y: Int, from: Spans, to: Spans) -> Unit) :
        Recovered(whole) {
        override fun spans(y: Int, spans: Spans) {
            val read = Spans()
            whole.spans(y, read)
            how(y, read, spans)
        }
    }

    private fun Frame.misread(how: (y: Int, from: Spans, to: Spans) -> Unit) =
        Frame(raster, primitives.map { Reading(it, how) }, region)

    private fun misreading(id: String, how: (y: Int, from: Spans, to: Spans) -> Unit) =
        drawing(id) { it.misread(how) }

    private const val TILE = 8
    private val ALL = 0..<Raster.MAX_SIDE

    /** The number of columns overflows, and what covers none is dropped. */
    fun losesHugeBounds() = drawing("loses-huge-bounds") { frame ->
        frame.keeping { with(frame.primitives[it]) { columnEnd - columnStart >= 0 || columnEnd < columnStart } }
    }
}
