package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.primitives
import dev.lazyz.filter.SuperSampling
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.strategies.lazy.LazyRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.painter.PainterRenderer

/** Renderers that are correct except for colours, and for when colours are computed. */
internal object ColourMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::keepsAttributes, "a surface without texture coordinates has those of another one"),
        Mistake(::constantColour, "shades a column once, in the primitive's first row"),
        Mistake(::fillsBetweenEqualEnds, "shows the colour of both neighbours where they have the same"),
        Mistake(::keepsColours, "shows the colour of the fragment shaded before where a primitive sets no colour"),
        Mistake(::oneStepShort, "a stepped colour is one step short"),
        Mistake(::shadesBeforeTheTest, "shades before the depth test"),
        Mistake(::shadesTwice, "shades each visible sample twice, and counts one"),
        Mistake(::countsNoSteps, "does not count steps"),
        Mistake(::countsWholeChains, "counts the steps of a row as one chain"),
    )

    fun shadesBeforeTheTest() =
        BrokenRenderer("shades-before-the-test", setOf(Capability.SHADES_ONLY_VISIBLE)) { frame, sink ->
            PainterRenderer().render(frame, sink)
        }

    fun shadesTwice() = BrokenRenderer("shades-twice", setOf(Capability.SHADES_ONLY_VISIBLE)) { frame, sink ->
        LazyRenderer().render(Frame(frame.raster, frame.primitives.map(::TwiceShaded), frame.region), sink)
    }

    fun oneStepShort() = stepping("one-step-short") { cursor, steps -> if (steps > 1) cursor.step() }

    fun countsNoSteps() = coherent("counts-no-steps") { frame, options, sink ->
        LazyRenderer(options).render(frame, sink).toBuilder().apply { shadingSteps = 0 }.build()
    }

    fun countsWholeChains() = coherent("counts-whole-chains") { frame, options, sink ->
        LazyRenderer(options).render(frame, sink).toBuilder().apply { longestChain = shadingSteps }.build()
    }

    /** A surface without texture coordinates has those that are left in the fragment. */
    fun keepsAttributes() = primitives("keeps-attributes") {
        object : Primitive by it {
            override fun shade(fragment: Fragment) {
                fragment.u = 0.25f
                fragment.v = 0.75f
                it.shade(fragment)
            }
        }
    }

    private class TwiceShaded(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            val (x, y) = fragment.x to fragment.y
            whole.shade(fragment)
            fragment.moveTo(x, y)
            whole.shade(fragment)
        }
    }

    private class Stepping(private val whole: Primitive, private val step: (ShadingCursor, Int) -> Unit) :
        Primitive by whole {
        override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
            val cursor = whole.shadingCursor(x, y) ?: return null
            var steps = 0
            return object : ShadingCursor by cursor {
                override fun step() = step(cursor, ++steps)
            }
        }
    }

    private fun stepping(id: String, step: (ShadingCursor, Int) -> Unit) = coherent(id) { frame, options, sink ->
        val primitives = frame.primitives.map { Stepping(it, step) }
        LazyRenderer(options).render(Frame(frame.raster, primitives, frame.region), sink)
    }

    /** Renders with the options of coherence by [how]. */
    internal fun coherent(
        id: String,
        options: RenderOptions = RenderOptions(),
        how: (Frame, RenderOptions, RowSink) -> Counters,
    ): BrokenRenderer = BrokenRenderer(id, setOf(Capability.COHERENCE), { coherent(id, it, how) }) { frame, sink ->
        how(frame, options, sink)
    }

    /** Paints the visible samples of the first primitive in the colour of its first sample. */
    fun constantColour() = primitives("colour-of-the-first-sample") { FirstColour(it) }

    fun fillsBetweenEqualEnds() = primitives("fills-between-equal-ends") { BetweenEqualEnds(it) }

    private class BetweenEqualEnds(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            val (x, y) = fragment.x to fragment.y
            val ends = listOf(x - 1, x + 1).map { whole.colorAt(it, y) }
            fragment.moveTo(if (ends[0] == ends[1]) x + 1 else x, y)
            whole.shade(fragment)
        }
    }

    /** Does not reset the colour of its fragment, but moves it. */
    fun keepsColours(): BrokenRenderer {
        val last = Fragment()
        return primitives("keeps-colours-that-are-not-set") { KeptColour(it, last) }
    }

    private class KeptColour(private val whole: Primitive, private val last: Fragment) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            fragment.setColor(last.red, last.green, last.blue, last.alpha)
            whole.shade(fragment)
            last.setColor(fragment.red, fragment.green, fragment.blue, fragment.alpha)
        }
    }

    private fun Primitive.colorAt(x: Int, y: Int): List<Float> {
        val fragment = Fragment().apply { moveTo(x, y) }
        shade(fragment)
        return with(fragment) { listOf(red, green, blue, alpha) }
    }

    private class FirstColour(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            fragment.moveTo(fragment.x, maxOf(whole.rowStart, 0))
            whole.shade(fragment)
        }
    }
}

/** Renderers that are correct except for how they add up the samples of a pixel. */
internal object PixelMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake({ WrongPixels("averages-codes", ::meanOfCodes) }, "averages codes instead of light"),
        Mistake({ WrongPixels("takes-one-sample") { it[0] } }, "shows one sample of a pixel"),
        Mistake({ WrongPixels("depth-of-one-sample", null) }, "a pixel has the depth of its first sample"),
    )

    private fun meanOfCodes(samples: IntArray): Int {
        fun mean(shift: Int) = samples.sumOf { it ushr shift and 0xFF } / samples.size shl shift
        return mean(24) or mean(16) or mean(8) or mean(0)
    }

    /** Its pixels have the colour that [color] returns for the colours of their samples, or null for the right one. */
    private class WrongPixels(id: String, private val color: ((IntArray) -> Int)?) : PlainRenderer(id) {
        override fun renderPixels(frame: Frame, side: Int, sink: RowSink): Counters {
            val samples = render(frame)
            val right = Image.Collector(frame.region.pixels(side)).let { it.toImage(filtered(frame, side, it)) }
            val width = frame.width / side
            for (row in 0 until frame.height / side) {
                val y = frame.region.rowStart / side + row
                val first = frame.region.columnStart / side
                val argb = IntArray(width) { x -> right.argb(first + x, y) }
                val depth = IntArray(width) { x -> right.depth(first + x, y) }
                val index = IntArray(width) { x -> right.primitive(first + x, y) }
                for (x in 0 until width) {
                    val left = side * (first + x)
                    if (color == null) {
                        depth[x] = samples.depth(left, side * y)
                    } else {
                        argb[x] = color(IntArray(side * side) { samples.argb(left + it % side, side * y + it / side) })
                    }
                }
                sink.row(y, argb, depth, index)
            }
            return samples.counters
        }

        private fun Region.pixels(side: Int) =
            Region(columnStart / side, rowStart / side, columnEnd / side, rowEnd / side)

        private fun filtered(frame: Frame, side: Int, sink: RowSink): Counters =
            SuperSampling(side).of(frame).render(PlainRenderer(), sink)
    }
}

/** Renderers that are correct except for extremes of alpha and light, and for primitives hidden behind glass. */
internal object GlassMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::zeroTimesInfinity, "adds fragments with alpha 0, so that infinite light becomes NaN"),
        Mistake(::stopsEarly, "stops blending at a transmittance of 1e-7"),
        Mistake(::multipliesByTheReciprocal, "multiplies sums by the reciprocal of the weights"),
        Mistake(::nanIsWhite, "NaN is packed as white"),
        Mistake(::shadesAhead, "shades all translucent fragments before it blends"),
    )

    /** A fragment of alpha 0 adds 0 times its light. */
    fun zeroTimesInfinity() = blending("zero-times-infinity") { cell -> blend(cell, isAdded = { true }) }

    fun stopsEarly() = blending("stops-early") { cell -> blend(cell, isOpen = { it > 1e-7f }) }

    fun multipliesByTheReciprocal() = blending("multiplies-by-the-reciprocal") { cell ->
        blend(cell, quotient = { sum, divisor -> sum * (1f / divisor) })
    }

    /** Shades all translucent fragments in front of the backdrop, and then blends. */
    fun shadesAhead() = blending("shades-ahead", setOf(Capability.SHADES_ONLY_VISIBLE)) { cell ->
        var i = 0
        while (i < cell.size && cell.isTranslucent(i)) cell.shade(i++)
        Selector.blend().select(cell)
    }

    /** Converts NaN to 1. */
    fun nanIsWhite() = primitives("nan-is-white") { Whitened(it) }

    private class Whitened(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            whole.shade(fragment)
            with(fragment) { setColor(white(red), white(green), white(blue), alpha) }
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

        private fun white(component: Float) = if (component.isNaN()) 1f else component
    }

    /**
     * Contract rule 5.5, with parameters for which fragments are added, up to which transmittance, and how sums are
     * divided.
     */
    private fun blend(
        cell: Cell,
        isAdded: (Float) -> Boolean = { it > 0f },
        isOpen: (Float) -> Boolean = { it > 0f },
        quotient: (Float, Float) -> Float = { sum, divisor -> sum / divisor },
    ) {
        if (!cell.isTranslucent(0)) return cell.show(0)
        var transmittance = 1f
        val sums = FloatArray(4)
        fun add(red: Float, green: Float, blue: Float, alpha: Float) {
            val opacity = if (alpha > 0f) minOf(alpha, 1f) else 0f
            if (!isAdded(opacity)) return
            val weight = transmittance * opacity
            for ((i, it) in floatArrayOf(red, green, blue, 1f).withIndex()) sums[i] += weight * it
            transmittance *= 1f - opacity
        }
        var i = 0
        while (i < cell.size && cell.isTranslucent(i) && isOpen(transmittance)) {
            with(cell.shade(i++)) { add(red, green, blue, alpha) }
        }
        if (isOpen(transmittance)) {
            val (light, alpha) = if (i < cell.size) {
                with(cell.shade(i)) { floatArrayOf(red, green, blue) to alpha }
            } else {
                with(cell.background) { floatArrayOf(red, green, blue) to alpha }
            }
            if (sums[3] == 0f) return cell.show(0, light[0], light[1], light[2], alpha)
            add(light[0], light[1], light[2], alpha)
        }
        val divisor = if (sums[3] == 0f) 1f else sums[3]
        val (red, green, blue) = sums.take(3).map { quotient(it, divisor) }
        cell.show(0, red, green, blue, sums[3])
    }

    private fun blending(id: String, promises: Set<Capability> = emptySet(), selector: Selector): BrokenRenderer =
        BrokenRenderer(id, promises + Capability.TRANSPARENCY) { frame: Frame, sink ->
            val chosen = if (frame.hasTranslucency) selector else Selector.nearest()
            ListsRenderer(RenderOptions(selector = chosen)).render(frame, sink)
        }
}
