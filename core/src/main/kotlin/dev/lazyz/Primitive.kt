@file:JvmName("Primitives")

package dev.lazyz

import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.ShadingObserver
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

/**
 * Something that covers samples of a raster. Renderers determine which primitive is visible at each sample.
 *
 * A primitive answers three questions: which samples it covers, its depth there, and its colour there. These are the
 * operations of Hill's paper. Implement this interface to add a custom primitive:
 *
 * | paper      | here                                                                     |
 * |------------|--------------------------------------------------------------------------|
 * | `within_y` | [rowStart] until [rowEnd]                                                |
 * | `within_x` | [spans]                                                                  |
 * | `step_y`   | [SpanCursor.next]                                                        |
 * | `step_x`   | one addition of [depthForm]'s `dx`, or [depth] again if there is no form |
 * | `depth`    | [depth]                                                                  |
 * | `shade`    | [shade]                                                                  |
 *
 * Every result must be a pure function of the primitive and the sample: the same bits for every call, in any order,
 * from any thread. A primitive must not cover samples outside its raster. `SetUp` converts surfaces to primitives.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 2.
 */
public interface Primitive {
    /** First row that can have covered samples. */
    public val rowStart: Int

    /** The row after the last row that can have covered samples; [rowStart] or less if nothing is covered. */
    public val rowEnd: Int

    /** First column that can have covered samples. */
    public val columnStart: Int

    /** The column after the last column that can have covered samples. */
    public val columnEnd: Int

    /**
     * Depth as a linear form whose integer part is [depth], or null if depth is not a linear form.
     *
     * At covered samples its integer part is in 0..2^31-1; elsewhere it may wrap around.
     */
    public val depthForm: LinearForm? get() = null

    /**
     * A lower bound of the depth at all covered samples, 0..2^31-1. A tight bound makes renderers that sort or reject
     * faster.
     */
    public val leastDepth: Int get() = 0

    /** An upper bound of the depth at all covered samples, 0..2^31-1; see [leastDepth]. */
    public val greatestDepth: Int get() = Int.MAX_VALUE

    /**
     * Whether the colour can have an alpha below 1, so that what is behind it shows through. A frame with such a
     * primitive needs a renderer with [Capability.TRANSPARENCY].
     */
    public val isTranslucent: Boolean get() = false

    /**
     * Upper bound of the memory, in bytes, that stays in use as long as this primitive is referenced. What it shares
     * with many others, such as a texture, is not counted. Renderers that keep primitives of a stream add these up to
     * stay within [RenderOptions.memoryBudget]. Override it in a primitive that holds more than the default.
     */
    public val heldBytes: Long get() = 256

    /**
     * Adds the spans of covered samples of row [y] to [spans], from left to right; no span is empty, and spans do not
     * overlap.
     *
     * [y] can be any row of the raster. Outside [rowStart] until [rowEnd] there is nothing to add.
     */
    public fun spans(y: Int, spans: Spans)

    /** Returns a cursor over the rows from [y] on. It gives the same spans as [spans], and can be faster. */
    public fun cursor(y: Int): SpanCursor = DirectCursor(this, y)

    /** Returns the depth at the covered sample at column [x], row [y], 0..2^31-1. */
    public fun depth(x: Int, y: Int): Int

    /**
     * Computes the colour at the covered sample [Fragment.x], [Fragment.y] and stores it in [fragment]. The renderer
     * has called [Fragment.moveTo] for this primitive and sample; a colour that is not set is opaque black.
     */
    public fun shade(fragment: Fragment)

    /**
     * Sets position, normal and texture coordinates of [fragment] to those of the surface at the covered sample
     * [Fragment.x], [Fragment.y], whether or not shading needs them. What the surface does not have keeps its default.
     * Does not count as a shading call.
     *
     * The default implementation calls [shade], and so leaves the attributes that shading has set. Override it in a
     * primitive whose shading is expensive, sets no attributes, or changes them.
     */
    public fun geometry(fragment: Fragment) {
        shade(fragment)
    }

    /**
     * Returns a cursor that steps shading along row [y] from column [x], or null if stepping is not faster. It gives
     * the same colours as [shade], bit for bit.
     */
    public fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    /**
     * Cost of evaluating the attributes at a sample directly, measured in steps of a [shadingCursor], at least 0.
     * [Coherence.ADAPTIVE] steps over at most this many columns; with 0 it never steps. The default, 1, means that a
     * step costs as much as a direct evaluation: it steps to the next column, but not across gaps. Override it where
     * direct evaluation is more expensive.
     */
    public val shadingStartCost: Int get() = 1
}

/** Returns this primitive if it is opaque; otherwise an opaque version of it, whose colours have alpha 1. */
public fun Primitive.asOpaque(): Primitive = if (isTranslucent) OpaquePrimitive(this) else this

/** The reference implementation of a cursor: evaluates each row directly. */
private class DirectCursor(private val primitive: Primitive, private var y: Int) : SpanCursor {
    override fun next(spans: Spans) {
        spans.clear()
        primitive.spans(y, spans)
        y++
    }
}

/** A primitive that covers no sample. It replaces primitives that are degenerate or not visible (contract rule 9.4). */
internal object EmptyPrimitive : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = 0
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = 0

    override fun spans(y: Int, spans: Spans) = Unit

    override fun depth(x: Int, y: Int): Int = error("an empty primitive has no depth")

    override fun shade(fragment: Fragment) = error("an empty primitive has no colour")

    override fun toString(): String = "EmptyPrimitive"
}

/** A primitive that is [whole], with a part of its coverage, or with other colours or shading. */
internal interface ChangedPrimitive : Primitive {
    val whole: Primitive
}

/** A primitive with the coverage and depth of [whole], whose colour is not computed: black. */
internal class UnshadedPrimitive(private val whole: Primitive) : Primitive by whole {
    override val shadingStartCost: Int get() = 0

    override fun shade(fragment: Fragment) {
        fragment.setColor(0f, 0f, 0f)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    override fun toString(): String = "UnshadedPrimitive($whole)"
}

/** A primitive like [whole], with the submission index [index], which reports each shading call to [observer]. */
internal class ObservedPrimitive(
    override val whole: Primitive,
    private val index: Int,
    private val observer: ShadingObserver,
) : ChangedPrimitive,
    Primitive by whole {
    override fun shade(fragment: Fragment) {
        observer.shading(fragment.x, fragment.y, index)
        whole.shade(fragment)
    }

    /** Without a shading call. */
    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { ObservedCursor(it) }

    override fun toString(): String = "ObservedPrimitive($whole)"

    private inner class ObservedCursor(private val cursor: ShadingCursor) : ShadingCursor {
        override fun step() = cursor.step()

        override fun shade(fragment: Fragment) {
            observer.shading(fragment.x, fragment.y, index)
            cursor.shade(fragment)
        }
    }
}
