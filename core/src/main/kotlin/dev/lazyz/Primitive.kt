@file:JvmName("Primitives")

package dev.lazyz

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

/**
 * Incremental shading: carries state from sample to sample along a row. Used by one thread.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4.
 */
public interface ShadingCursor {
    /**
     * Moves to the next column. Less expensive than a direct evaluation; [Primitive.shadingStartCost] gives the ratio.
     */
    public fun step()

    /** Computes the colour at the current column. [fragment] has already been moved there. */
    public fun shade(fragment: Fragment)
}

/** Returns the spans of a primitive row by row, downward. Used by one thread. */
public fun interface SpanCursor {
    /** Replaces the contents of [spans] with the spans of the current row, then moves to the next row. */
    public fun next(spans: Spans)
}

/** The reference implementation of a cursor: evaluates each row directly. */
private class DirectCursor(private val primitive: Primitive, private var y: Int) : SpanCursor {
    override fun next(spans: Spans) {
        spans.clear()
        primitive.spans(y, spans)
        y++
    }
}

/**
 * A linear function of the sample position: v(x, y) = c + dx x + dy y, in 64-bit two's complement.
 *
 * x and y are the column and row of a sample. Addition wraps and is associative, so stepping along a row by [dx],
 * stepping down a column by [dy] and evaluating with [at] give the same result, bit for bit (contract rule 3.1). In the
 * form of a depth, the upper 32 bits are the integer part and the lower 32 the fraction. Edge functions are plain
 * integers. Immutable and thread safe.
 *
 * @property c value at sample (0, 0)
 * @property dx change from one column to the next
 * @property dy change from one row to the next
 */
public class LinearForm(public val c: Long, public val dx: Long, public val dy: Long) {
    /** Returns the value at sample ([x], [y]). Cost: two multiplications. */
    public fun at(x: Int, y: Int): Long = c + dx * x + dy * y

    override fun equals(other: Any?): Boolean =
        other is LinearForm && c == other.c && dx == other.dx && dy == other.dy

    override fun hashCode(): Int = (c.hashCode() * 31 + dx.hashCode()) * 31 + dy.hashCode()

    override fun toString(): String = "LinearForm($c + $dx x + $dy y)"

    public companion object {
        /** Returns the form whose integer part is [value] everywhere. */
        @JvmStatic
        public fun constant(value: Int): LinearForm = LinearForm((value.toLong() shl 32) + HALF, 0, 0)

        /** Half a unit of the integer part. It is added once, so that truncating the fraction rounds to nearest. */
        internal const val HALF: Long = 1L shl 31
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

/** A primitive with the coverage and depth of [whole], whose colour is not computed: black. */
internal class UnshadedPrimitive(private val whole: Primitive) : Primitive by whole {
    override val shadingStartCost: Int get() = 0

    override fun shade(fragment: Fragment) {
        fragment.setColor(0f, 0f, 0f)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    override fun toString(): String = "UnshadedPrimitive($whole)"
}
