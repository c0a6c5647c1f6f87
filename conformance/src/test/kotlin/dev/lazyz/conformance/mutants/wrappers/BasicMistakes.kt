package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.mutants.AtDepth
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.FilledGaps
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.ShiftedShade
import dev.lazyz.conformance.mutants.ShortSpans
import dev.lazyz.conformance.mutants.counting
import dev.lazyz.conformance.mutants.coversAnything
import dev.lazyz.conformance.mutants.drawing
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.conformance.mutants.on
import dev.lazyz.conformance.mutants.primitives
import dev.lazyz.conformance.mutants.rows
import dev.lazyz.conformance.mutants.swappedTies
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/**
 * Renderers with a single mistake.
 *
 * Each function returns a new renderer, because some have state.
 */
internal object BasicMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::colourOfTheLoser, "on ties, index and depth are right, but the colour is that of the other fragment"),
        Mistake(::shadesTheNeighbour, "shades the sample to the left"),
        Mistake(::blendsAsSubmitted, "blends in the order of submission"),
        Mistake(::blendsFromTheBack, "blends from the back, which rounds differently"),
        Mistake(::translucentAsOpaque, "draws translucent primitives as if they were opaque, without an error"),
        Mistake(::spanEndsEarly, "every span lacks its last column"),
        Mistake(::gapsFilled, "one span a row, from the first start to the last end"),
        Mistake(::linearFormsOnly, "primitives without a linear form are not drawn"),
        Mistake(::needsAPrimitive, "fails without primitives"),
        Mistake(::needsTwoColumns, "fails on rasters of a single column"),
        Mistake(::lastWinsTies, "compares with `<=` instead of `<`"),
        Mistake(::usualTestOnly, "the usual depth test, whatever the raster says"),
        Mistake(::lastSubmittedWins, "the painter's algorithm without its sort"),
        Mistake(::backgroundAtInfinity, "a background that is always behind everything"),
        Mistake(::dropsTheInvisible, "primitives that cover nothing get no index, so later primitives have wrong ones"),
        Mistake(::countsACallTooMany, "counts a shading call that never happens"),
        Mistake(::countsNoPasses, "does not count depth passes"),
        Mistake(::bottomUp, "rows from the bottom"),
        Mistake(::firstRowTwice, "the first row two times"),
        Mistake(::lastRowMissing, "all rows but the last"),
        Mistake(::ignoresTheRegion, "the whole raster, whatever the region"),
        Mistake(::remembersTheLastFrame, "the background shows the frame before"),
        Mistake(::oneThreadOnly, "the frame is in a field, so that concurrent calls render each other's frames"),
    )

    /** `<=` where `<` is meant. */
    fun lastWinsTies() = drawing("last-wins-ties") { frame -> frame.on { withDepthTest(swappedTies(depthTest)) } }

    /** Correct indices and depths, but on ties the colour of the other primitive. */
    fun colourOfTheLoser() = BrokenRenderer("colour-of-the-loser") { frame, sink ->
        val right = ZBufferRenderer().render(frame)
        val wrong = ZBufferRenderer().render(frame.on { withDepthTest(swappedTies(depthTest)) })
        emit(Image(right.region, wrong.argb, right.depth, right.primitive, right.counters), sink)
    }

    /** The default depth test, whatever the raster says. */
    fun usualTestOnly() = drawing("usual-test-only") { frame -> frame.on { withDepthTest(convention.nearest) } }

    /** The painter's algorithm without its sort. */
    fun lastSubmittedWins() = drawing("last-submitted-wins") { frame ->
        val last = frame.raster.withDepthTest(DepthTest.LESS_OR_EQUAL)
        Frame(last, frame.primitives.map { AtDepth(it, 0) }, frame.region)
    }

    /** A background that is always behind everything. */
    fun backgroundAtInfinity() = drawing("background-at-infinity") { frame ->
        frame.on { withBackgroundDepth(Rasters.behindAll(depthTest)) }
    }

    /** Spans without their last column. */
    fun spanEndsEarly() = primitives("span-ends-early") { ShortSpans(it) }

    /** One span a row, from the first start to the last end. */
    fun gapsFilled() = primitives("gaps-filled") { FilledGaps(it) }

    /** Colours of the sample to the left. */
    fun shadesTheNeighbour() = primitives("shades-the-neighbour") { ShiftedShade(it) }

    /** No primitives without a linear form. */
    fun linearFormsOnly() = drawing("linear-forms-only") { frame ->
        frame.keeping { frame.primitives[it].depthForm != null }
    }

    /** Primitives that cover nothing have no index. */
    fun dropsTheInvisible() = drawing("drops-the-invisible") { frame ->
        Frame(frame.raster, frame.primitives.filter { it.coversAnything() }, frame.region)
    }

    /** Rows from the bottom. */
    fun bottomUp() = rows("bottom-up") { height -> List(height) { height - 1 - it } }

    /** The first row two times. */
    fun firstRowTwice() = rows("first-row-twice") { height -> listOf(0) + (0 until height) }

    /** All rows but the last. */
    fun lastRowMissing() = rows("last-row-missing") { height -> (0 until height - 1).toList() }

    /** Samples of the background show what the previous frame showed there. */
    fun remembersTheLastFrame(): BrokenRenderer {
        var last = IntArray(0)
        return BrokenRenderer("remembers-the-last-frame") { frame, sink ->
            val image = ZBufferRenderer().render(frame)
            for (i in image.argb.indices) {
                if (image.primitive[i] == DepthTest.BACKGROUND && i < last.size) image.argb[i] = last[i]
            }
            last = image.argb
            emit(image, sink)
        }
    }

    /** Keeps the frame in a field, so that threads render each other's frames. */
    fun oneThreadOnly(): BrokenRenderer {
        var current: Frame? = null
        return BrokenRenderer("one-thread-only") { frame, sink ->
            current = frame
            Thread.sleep(1)
            ZBufferRenderer().render(checkNotNull(current), sink)
        }
    }

    /** Counts a shading call that never happens. */
    fun countsACallTooMany() = counting("counts-a-call-too-many") { shadingCalls++ }

    /** Does not count depth passes. */
    fun countsNoPasses() = counting("counts-no-passes") { depthPasses = 0 }

    /** The whole raster, whatever the region. */
    fun ignoresTheRegion() = drawing("ignores-the-region") { Frame(it.raster, it.primitives) }

    /** Treats translucent primitives as opaque instead of rejecting them. */
    fun translucentAsOpaque() = drawing("translucent-as-opaque") { it.asOpaque() }

    /** Blends in the order of submission. */
    fun blendsAsSubmitted() = blending("blends-as-submitted") { cell ->
        over(cell, cell.upToBackdrop().sortedByDescending { cell.primitive(it) })
    }

    /** The order of sums of textbooks, from the back: the same except for the last bits. */
    fun blendsFromTheBack() = blending("blends-from-the-back") { cell -> over(cell, cell.upToBackdrop().reversed()) }

    /** Fails without primitives. */
    fun needsAPrimitive() = drawing("needs-a-primitive") { frame -> frame.also { it.primitives.first() } }

    /** Fails on a single column. */
    fun needsTwoColumns() = drawing("needs-two-columns") { frame -> frame.also { check(it.raster.width > 1) } }

    private fun Cell.upToBackdrop(): List<Int> {
        val backdrop = (0 until size).firstOrNull { !isTranslucent(it) } ?: (size - 1)
        return (0..backdrop).toList()
    }

    /** Shows the fragments [fromBack], one over the other, over the background. */
    private fun over(cell: Cell, fromBack: List<Int>, rounded: (Rgba) -> Rgba = { it }) {
        var color = cell.background
        for (i in fromBack) {
            val fragment = cell.shade(i)
            val a = fragment.alpha.coerceIn(0f, 1f)
            val alpha = a + color.alpha * (1 - a)
            fun mix(front: Float, back: Float) =
                if (alpha == 0f) 0f else (a * front + (1 - a) * color.alpha * back) / alpha
            val (red, green, blue) = listOf(
                mix(fragment.red, color.red), mix(fragment.green, color.green), mix(fragment.blue, color.blue),
            )
            color = rounded(Rgba(red, green, blue, alpha))
        }
        cell.show(0, color.red, color.green, color.blue, color.alpha)
    }

    private fun blending(id: String, selector: Selector) =
        BrokenRenderer(id, setOf(Capability.TRANSPARENCY)) { frame, sink ->
            val chosen = if (frame.hasTranslucency) selector else Selector.nearest()
            ListsRenderer(RenderOptions(selector = chosen)).render(frame, sink)
        }
}
