package dev.lazyz.conformance.strangers4

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor

/** Shades a decided row from left to right; under coherence each primitive has a chain of steps along the row. */
internal class SweepShading(
    private val frame: Frame,
    private val coherence: Coherence,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private val chains = HashMap<Int, Chain>()
    private val fragment = Fragment()
    private val background =
        frame.raster.background.toArgb() or if (mistake == Mistake.SWEEP_BACKGROUND_SOLID) SOLID else 0
    private var mostChains = 0

    val argb: IntArray = IntArray(frame.width)

    val bytes: Long get() = 4L * argb.size + CHAIN_BYTES * mostChains

    fun shade(y: Int, indices: IntArray) {
        if (mistake != Mistake.SWEEP_CHAINS_KEPT) chains.clear()
        var waiting = 0L
        for (i in 0 until frame.width) if (indices[i] != DepthTest.BACKGROUND) waiting++
        counters.peakSuspensions = maxOf(counters.peakSuspensions, waiting)
        for (i in 0 until frame.width) {
            val index = indices[i]
            argb[i] = if (index == DepthTest.BACKGROUND) background else color(index, frame.region.columnStart + i, y)
        }
        mostChains = maxOf(mostChains, chains.size)
    }

    private fun color(index: Int, x: Int, y: Int): Int {
        counters.shadingCalls++
        val primitive = frame.primitives[index]
        fragment.moveTo(x, y)
        val cursor = if (mayStep(primitive)) cursor(index, primitive, x, y) else null
        if (cursor == null) {
            counters.shadingStarts++
            primitive.shade(fragment)
        } else {
            cursor.shade(fragment)
        }
        return fragment.toArgb()
    }

    private fun mayStep(primitive: Primitive): Boolean = when (coherence) {
        Coherence.DIRECT -> false
        Coherence.INCREMENTAL -> true
        Coherence.ADAPTIVE -> primitive.shadingStartCost > 0
    }

    private fun cursor(index: Int, primitive: Primitive, x: Int, y: Int): ShadingCursor? {
        val chain = chains[index]
        if (chain != null && isWorthIt(primitive, x - chain.x)) {
            val gap = x - chain.x
            repeat(gap) { chain.cursor.step() }
            counters.shadingSteps += gap
            val length = if (mistake == Mistake.SWEEP_CHAIN_SUMMED) x - chain.start else gap
            counters.longestChain = maxOf(counters.longestChain, length.toLong())
            chain.x = x
            return chain.cursor
        }
        val cursor = primitive.shadingCursor(x, y) ?: return null
        counters.shadingStarts++
        chains[index] = Chain(cursor, x)
        return cursor
    }

    private fun isWorthIt(primitive: Primitive, gap: Int): Boolean = when {
        coherence == Coherence.INCREMENTAL -> true
        mistake == Mistake.SWEEP_GAP_BELOW_COST -> gap < primitive.shadingStartCost
        else -> gap <= primitive.shadingStartCost
    }

    private class Chain(val cursor: ShadingCursor, var x: Int) {
        val start = x
    }

    private companion object {
        const val CHAIN_BYTES = 128L
        const val SOLID = 0xFF shl 24
    }
}
