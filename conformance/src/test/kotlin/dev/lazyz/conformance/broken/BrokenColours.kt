package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.ShadingCursor
import dev.lazyz.strategies.lazy.LazyZBuffer
import dev.lazyz.strategies.painter.Painter

/** Renderers that are correct except for colours, and for when colours are computed. */
object BrokenColours {

    fun shadesBeforeTheTest() =
        BrokenRenderer("shades-before-the-test", setOf(Capability.SHADES_ONLY_VISIBLE)) { frame, sink ->
            Painter().render(frame, sink)
        }

    fun shadesTwice() = BrokenRenderer("shades-twice", setOf(Capability.SHADES_ONLY_VISIBLE)) { frame, sink ->
        LazyZBuffer().render(Frame(frame.raster, frame.primitives.map(::TwiceShaded), frame.region), sink)
    }

    fun oneStepShort() = stepping("one-step-short") { cursor, steps -> if (steps > 1) cursor.step() }

    fun countsNoSteps() = coherent("counts-no-steps") { frame, options, sink ->
        LazyZBuffer(options).render(frame, sink).toBuilder().apply { shadingSteps = 0 }.build()
    }

    fun countsWholeChains() = coherent("counts-whole-chains") { frame, options, sink ->
        LazyZBuffer(options).render(frame, sink).toBuilder().apply { longestChain = shadingSteps }.build()
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
        LazyZBuffer(options).render(Frame(frame.raster, primitives, frame.region), sink)
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
