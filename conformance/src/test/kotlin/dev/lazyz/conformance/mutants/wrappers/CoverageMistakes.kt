package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.changed.Cutting
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.drawing
import dev.lazyz.spi.Spans

/** Renderers that are correct except for coverage. */
internal object CoverageMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::spansStartLate, "every span lacks its first column"),
        Mistake(::tileColumnMissing, "the last column of each tile of 8 x 8 samples is not drawn"),
        Mistake(::tileRowMissing, "the last row of each tile of 8 x 8 samples is not drawn"),
        Mistake(::lateActivation, "primitives become active a row late"),
        Mistake(::earlyRetirement, "primitives end a row early"),
        Mistake(::singleSamplesLost, "rows in which a primitive has a single sample are lost"),
        Mistake(::losesHugeBounds, "the number of columns of a primitive overflows"),
        Mistake(::firstSpanOnly, "only the first span of a row is drawn"),
        Mistake(::windingInverted, "holes are filled, and the area around them is not"),
    )

    fun firstSpanOnly() = misreading("first-span-only") { _, from, to ->
        if (from.count > 0) to.add(from.start(0), from.end(0))
    }

    fun windingInverted() = misreading("winding-inverted") { _, from, to ->
        if (from.count == 1) to.add(from.start(0), from.end(0))
        for (i in 0 until from.count - 1) to.add(from.end(i), from.start(i + 1))
    }

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

    private fun misreading(id: String, how: (y: Int, from: Spans, to: Spans) -> Unit) = drawing(id) { it.misread(how) }

    private const val TILE = 8
    private val ALL = 0..<Raster.MAX_SIDE

    /** The number of columns overflows, and what covers none is dropped. */
    fun losesHugeBounds() = drawing("loses-huge-bounds") { frame ->
        frame.keeping { with(frame.primitives[it]) { columnEnd - columnStart >= 0 || columnEnd < columnStart } }
    }
}
