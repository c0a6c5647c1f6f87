package dev.lazyz.conformance.strangers3

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor
import dev.lazyz.Spans

/** Late shading along a row, from left to right; steps as the option says. */
internal class RowShading(
    private val frame: Frame,
    private val coherence: Coherence,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private class Link(val cursor: ShadingCursor, var x: Int)

    private val fragment = Fragment()
    private val links = HashMap<Int, Link>()

    /** Bytes at their peak. */
    var bytes = 0L
        private set

    /** Ends all chains. */
    fun beginRow() {
        if (mistake != Mistake.SPANS_CHAIN_OVER_ROWS) links.clear()
    }

    /** Returns the shaded fragment; it is overwritten by the next call. */
    fun shade(x: Int, y: Int, index: Int): Fragment {
        val primitive = frame.primitives[index]
        counters.shadingCalls++
        if (mistake != Mistake.SPANS_MOVE_ON_START) fragment.moveTo(x, y)
        val cursor = if (steps(primitive)) cursor(primitive, x, y, index) else null
        if (cursor == null) {
            fragment.moveTo(x, y)
            if (coherence == Coherence.DIRECT || mistake != Mistake.EVENTS_START_UNCOUNTED) counters.shadingStarts++
            primitive.shade(fragment)
        } else {
            cursor.shade(fragment)
        }
        return fragment
    }

    private fun steps(primitive: Primitive): Boolean = when (coherence) {
        Coherence.DIRECT -> false
        Coherence.INCREMENTAL -> true
        Coherence.ADAPTIVE -> primitive.shadingStartCost > 0
    }

    private fun cursor(primitive: Primitive, x: Int, y: Int, index: Int): ShadingCursor? {
        val link = links[index]
        if (link != null && x >= link.x && isNear(x - link.x, primitive)) {
            val gap = x - link.x
            repeat(gap) { link.cursor.step() }
            link.x = x
            counters.shadingSteps += gap
            counters.longestChain =
                if (mistake == Mistake.SPANS_LONGEST_LAST) gap.toLong() else maxOf(counters.longestChain, gap.toLong())
            return link.cursor
        }

        // Begin a chain here
        val from = if (mistake == Mistake.EVENTS_CHAIN_FROM_LEFT && link == null) spanStart(primitive, x, y) else x
        val cursor = primitive.shadingCursor(from, y) ?: return null
        repeat(x - from) { cursor.step() }
        counters.shadingSteps += x - from
        counters.shadingStarts++
        if (mistake == Mistake.SPANS_MOVE_ON_START) fragment.moveTo(x, y)
        links[index] = Link(cursor, x)
        bytes = maxOf(bytes, links.size * LINK_BYTES)
        return cursor
    }

    private fun isNear(gap: Int, primitive: Primitive): Boolean {
        if (coherence == Coherence.INCREMENTAL) return true
        val cost = primitive.shadingStartCost
        return if (mistake == Mistake.SPANS_ADAPTIVE_BELOW) gap < cost else gap <= cost
    }

    /** Where the span that holds column [x] begins; for one mistake only. */
    private fun spanStart(primitive: Primitive, x: Int, y: Int): Int {
        val spans = Spans(frame.region)
        primitive.spans(y, spans)
        return (0 until spans.count).first { x < spans.end(it) }.let(spans::start)
    }

    private companion object {
        const val LINK_BYTES = 152L
    }
}
