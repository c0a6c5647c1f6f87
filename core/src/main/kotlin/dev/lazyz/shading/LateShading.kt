package dev.lazyz.shading

import dev.lazyz.Blending
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor

/**
 * Computes the colours of a row once visibility is known: one shading call for each visible sample.
 *
 * Used by all renderers that shade late. Only the primitive's index has to be stored until then, because primitive and
 * sample determine the colour (contract rule 6.1). Under [Coherence.INCREMENTAL], each primitive that is visible on the
 * row has a chain of steps along the row. Where the primitive is hidden, the steps are made without shading. So a chain
 * costs steps for its gaps, and saves evaluating the attributes where the primitive is visible. Under
 * [Coherence.ADAPTIVE], a gap is stepped over if that costs no more than a new chain, according to
 * [Primitive.shadingStartCost].
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4. There a chain begins at
 * the primitive's first sample on the row. Here it begins at the first visible sample, which gives the same colours at
 * lower cost.
 *
 * Used by one thread.
 *
 * @param checkpoint passed for each shading call, because shaders may take long
 */
internal class LateShading(
    private val frame: Frame,
    private val coherence: Coherence,
    private val counters: Counters.Builder,
    private val checkpoint: Checkpoint,
) {
    private val fragment = Fragment()
    private val background = frame.raster.background.toArgb()
    private val firstColumn = frame.region.columnStart

    /**
     * The chains of this row, by primitive, and the most recent one, because neighbours are usually of the same
     * primitive.
     */
    private val chains = HashMap<Int, ShadingChain>()
    private var last: ShadingChain? = null

    /** Peak memory of the chains, in bytes, estimated from their fields. */
    var peakBytes: Long = 0
        private set

    private class ShadingChain(val index: Int, val cursor: ShadingCursor, var x: Int)

    /**
     * Computes the colours of row [y] into [argb]. [indices] has the visible primitive of each column, from the first
     * column of the region on.
     */
    fun shadeRow(y: Int, indices: IntArray, argb: IntArray) {
        beginRow()
        for (i in 0 until frame.width) {
            val index = indices[i]
            argb[i] = if (index == DepthTest.BACKGROUND) background else shade(firstColumn + i, y, index)
        }
    }

    /** Ends all chains. Must be called before each row that is not shaded with [shadeRow]. */
    fun beginRow() {
        chains.clear()
        last = null
    }

    /**
     * Returns the colour of the primitive [index] at a sample, `0xAARRGGBB`. Within a row, columns must not decrease.
     */
    fun shade(x: Int, y: Int, index: Int): Int = shaded(x, y, index, frame.primitives[index]).toArgb()

    /**
     * As [shade], for a [primitive] that need not be in the frame. Returns a fragment with the unpacked colour, which
     * is valid until the next call.
     */
    fun shaded(x: Int, y: Int, index: Int, primitive: Primitive): Fragment {
        checkpoint.pass()
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

    /** Returns a cursor for the primitive [index] at column [x], or null if the primitive does not support stepping. */
    private fun cursorAt(x: Int, y: Int, index: Int, primitive: Primitive): ShadingCursor? {
        // Continue the primitive's chain
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

        // Begin a new chain
        val cursor = primitive.shadingCursor(x, y) ?: return null
        counters.shadingStarts++
        last = ShadingChain(index, cursor, x).also { chains[index] = it }
        peakBytes = maxOf(peakBytes, chains.size * HeapLayout.SHADING_CHAIN)
        return cursor
    }

    private fun isWorthStepping(gap: Int, primitive: Primitive): Boolean =
        coherence == Coherence.INCREMENTAL || gap <= primitive.shadingStartCost

    companion object {
        /** Returns the largest [peakBytes] that shading a row of [frame] with chains of steps can take. */
        fun mostBytes(frame: Frame): Long = HeapLayout.SHADING_CHAIN * minOf(frame.width, frame.primitives.size)
    }
}

/**
 * Computes the colour of a sample from its translucent fragments and the opaque one behind them (contract rule 5.5),
 * once their order is known. Fragments are shaded from the nearest on, and only as long as light passes.
 *
 * Used by one thread.
 */
internal class LayerShading(private val frame: Frame, private val shading: LateShading) {
    private val blending = Blending()
    private val background = frame.raster.background
    private val backgroundArgb = background.toArgb()

    /**
     * Returns the colour, `0xAARRGGBB`, of a sample at which the first [count] primitives of [layers] are visible, from
     * near to far, before the opaque primitive [backdrop], or before the background. Within a row, columns must not
     * decrease.
     */
    fun shade(x: Int, y: Int, layers: IntArray, count: Int, backdrop: Int): Int = when {
        count > 0 -> blending.blend(count, backdrop != DepthTest.BACKGROUND, background) { i ->
            val index = if (i < count) layers[i] else backdrop
            shading.shaded(x, y, index, frame.primitives[index])
        }
        backdrop == DepthTest.BACKGROUND -> backgroundArgb
        else -> shading.shade(x, y, backdrop)
    }
}
