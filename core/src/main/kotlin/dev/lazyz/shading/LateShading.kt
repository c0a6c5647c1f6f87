package dev.lazyz.shading

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor

/**
 * Forces the suspended colours of a row, once it is known what is visible: one shading call a visible sample.
 *
 * Shared by all renderers that shade late. A suspension is no more than the index of the primitive: primitive and sample
 * determine the colour (contract rule 6.1). What is carried along the row under [Coherence.INCREMENTAL] is a chain of
 * steps, one for each primitive seen on the row: where the primitive is hidden the steps are still made, the colours are
 * dropped; so a chain costs steps for its gaps, and saves evaluating the attributes where it is visible. Under
 * [Coherence.ADAPTIVE] a gap is stepped over if that costs no more than a new chain, by the primitive's own word
 * ([Primitive.shadingStartCost]).
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4. There a chain begins at
 * the primitive's first sample on the row; here at the first that is visible, which gives the same colours for less.
 *
 * Belongs to one thread.
 */
internal class LateShading(private val frame: Frame, private val coherence: Coherence, private val counters: Counters) {
    private val fragment = Fragment()
    private val background = frame.raster.background.toArgb()
    private val firstColumn = frame.region.columnStart

    /** The chains of this row, by primitive, and the one that was used last: neighbours are mostly of one primitive. */
    private val chains = HashMap<Int, ShadingChain>()
    private var last: ShadingChain? = null

    /** Bytes held by chains at their most numerous, estimated by the size of their fields. */
    var peakBytes: Long = 0
        private set

    private class ShadingChain(val index: Int, val cursor: ShadingCursor, var x: Int)

    /**
     * Computes the colours of row [y] for the visible primitives of [indices] (one a column, from the region's first)
     * into [argb].
     */
    fun shadeRow(y: Int, indices: IntArray, argb: IntArray) {
        beginRow()
        for (i in 0 until frame.width) {
            val index = indices[i]
            argb[i] = if (index == DepthTest.BACKGROUND) background else shade(firstColumn + i, y, index)
        }
    }

    /** Ends all chains. To be called before each row that is not shaded by [shadeRow]. */
    fun beginRow() {
        chains.clear()
        last = null
    }

    /** Computes the colour of the primitive [index] at a sample. Within a row, columns do not decrease. */
    fun shade(x: Int, y: Int, index: Int): Int = shaded(x, y, index, frame.primitives[index]).toArgb()

    /**
     * As [shade], for a [primitive] that the frame need not hold. Returns a fragment with the colour, not packed; it is
     * valid until the next call.
     */
    fun shaded(x: Int, y: Int, index: Int, primitive: Primitive): Fragment {
        counters.shadingCalls++
        fragment.moveTo(x, y)
        val cursor = if (mayStep(primitive)) cursorAt(x, y, index, primitive) else null
        if (cursor != null) {
            cursor.shade(fragment)
        } else {
            counters.shadingStarts++
            primitive.shade(fragment)
        }
        return fragment
    }

    private fun mayStep(primitive: Primitive): Boolean = when (coherence) {
        Coherence.DIRECT -> false
        Coherence.INCREMENTAL -> true
        Coherence.ADAPTIVE -> primitive.shadingStartCost > 0
    }

    /** Returns shading of the primitive [index] at column [x], or null if the primitive has none that steps. */
    private fun cursorAt(x: Int, y: Int, index: Int, primitive: Primitive): ShadingCursor? {
        // Go on with the primitive's chain
        val chain = last?.takeIf { it.index == index } ?: chains[index]
        if (chain != null && isWorthStepping(x - chain.x, primitive)) {
            val gap = x - chain.x
            for (step in 0 until gap) chain.cursor.step()
            chain.x = x
            counters.shadingSteps += gap
            counters.longestChain = maxOf(counters.longestChain, gap.toLong())
            last = chain
            return chain.cursor
        }

        // Begin a new one
        val cursor = primitive.shadingCursor(x, y) ?: return null
        counters.shadingStarts++
        last = ShadingChain(index, cursor, x).also { chains[index] = it }
        peakBytes = maxOf(peakBytes, chains.size * CHAIN_BYTES)
        return cursor
    }

    private fun isWorthStepping(gap: Int, primitive: Primitive): Boolean =
        coherence == Coherence.INCREMENTAL || gap <= primitive.shadingStartCost

    private companion object {
        /** A chain: two objects of a header and five 8-byte fields, and an entry of the map. */
        const val CHAIN_BYTES = 152L
    }
}
