package dev.lazyz.conformance.strangers5

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.ShadingCursor

/** Colours along a row, by steps or each by itself, as [coherence] says. */
internal class Chains(
    private val frame: Frame,
    private val coherence: Coherence,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private class Chain(val cursor: ShadingCursor, var x: Int) {
        var total = 0L
    }

    private val fragment = Fragment()
    private val chains = HashMap<Int, Chain>()

    /** Bytes held at most. */
    var peakBytes: Long = 0
        private set

    /** Begins a row. */
    fun beginRow() {
        if (mistake != Mistake.CASTER_CHAIN_OVER_ROWS) chains.clear()
    }

    /** Shades the primitive [index] at a sample. Valid until the next call. */
    fun shade(x: Int, y: Int, index: Int): Fragment {
        val primitive = frame.primitives[index]
        counters.shadingCalls++
        counters.peakSuspensions = maxOf(counters.peakSuspensions, 1L)
        fragment.moveTo(x, y)
        val cost = if (coherence == Coherence.ADAPTIVE) primitive.shadingStartCost else Int.MAX_VALUE
        if (coherence == Coherence.DIRECT || cost == 0) {
            counters.shadingStarts++
            primitive.shade(fragment)
            return fragment
        }

        // Go on with a chain, if it is worth it
        val chain = chains[index]
        val most = if (mistake == Mistake.CASTER_ADAPTIVE_STEPS) Int.MAX_VALUE else cost
        if (chain != null && x >= chain.x && x - chain.x <= most) {
            val gap = x - chain.x
            repeat(gap) { chain.cursor.step() }
            chain.x = x
            chain.total += gap
            counters.shadingSteps += gap
            val length = if (mistake == Mistake.CASTER_CHAIN_SUM) chain.total else gap.toLong()
            counters.longestChain = maxOf(counters.longestChain, length)
            chain.cursor.shade(fragment)
            return fragment
        }
        counters.shadingStarts++
        val cursor = primitive.shadingCursor(x, y)
        if (cursor == null) {
            primitive.shade(fragment)
            return fragment
        }
        chains[index] = Chain(cursor, x)
        peakBytes = maxOf(peakBytes, chains.size * 128L)
        cursor.shade(fragment)
        return fragment
    }
}
