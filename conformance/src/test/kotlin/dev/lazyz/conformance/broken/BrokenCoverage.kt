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

    fun singleSamplesLost() = misreading("single-samples-lost") { _, from, to ->
        for (i in 0 until from.count) if (from.start(i) + 1 < from.end(i)) to.add(from.start(i), from.end(i))
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
