package dev.lazyz

/**
 * Something that covers samples of a raster: what a renderer orders.
 *
 * A renderer asks three questions only: which samples do you cover, how deep are you there, what colour are you there.
 * They are the operations of Hill's paper, and a primitive of one's own answers them in the same way:
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
 * Every answer is a pure function of the primitive and the sample: the same bits at every call, in any order, from any
 * thread. A primitive never covers a sample outside its raster. `SetUp` makes primitives of surfaces.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 2.
 */
public interface Primitive {
    /** First row that may be covered. */
    public val rowStart: Int

    /** The row after the last that may be covered; [rowStart] or less if none is. */
    public val rowEnd: Int

    /** First column that may be covered. */
    public val columnStart: Int

    /** The column after the last that may be covered. */
    public val columnEnd: Int

    /**
     * Depth as a linear form whose integer part is [depth], or null if depth is no linear form.
     *
     * At covered samples its integer part is in 0..2^31-1; elsewhere it may wrap around.
     */
    public val depthForm: LinearForm? get() = null

    /**
     * A lower bound of the depth at all covered samples, 0..2^31-1. A close one helps renderers that sort or reject.
     */
    public val leastDepth: Int get() = 0

    /** An upper bound of the depth at all covered samples, 0..2^31-1; see [leastDepth]. */
    public val greatestDepth: Int get() = Int.MAX_VALUE

    /**
     * Whether the colour may let through what lies behind, so that a picture needs blending. A frame with such
     * primitives needs a renderer that blends, see [Capability.TRANSPARENCY].
     */
    public val isTranslucent: Boolean get() = false

    /**
     * Bytes of memory that stay in use as long as this primitive is kept, at most; what it shares with many others, such
     * as a texture, is not counted. Renderers that keep primitives of a stream within [RenderOptions.memoryBudget] add
     * these up. Override it in a primitive that holds more.
     */
    public val heldBytes: Long get() = 256

    /**
     * Adds the spans of covered samples of row [y] to [spans], from left to right, none of them empty, none overlapping.
     *
     * [y] may be any row of the raster; outside [rowStart] until [rowEnd] there is nothing to add.
     */
    public fun spans(y: Int, spans: Spans)

    /** Returns a cursor over the rows from [y] on. It gives the spans that [spans] gives, and may be faster. */
    public fun cursor(y: Int): SpanCursor = DirectCursor(this, y)

    /** Returns the depth at a covered sample, 0..2^31-1. */
    public fun depth(x: Int, y: Int): Int

    /** Computes the colour at the covered sample [Fragment.x], [Fragment.y] and leaves it in the fragment. */
    public fun shade(fragment: Fragment)

    /**
     * Returns shading that steps along row [y] from column [x], or null if there is nothing to gain from it. It gives
     * the colours that [shade] gives, bit for bit.
     */
    public fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    /**
     * What it costs to evaluate the attributes of one sample afresh, in steps of a [shadingCursor], at least 0.
     * [Coherence.ADAPTIVE] steps over as many columns and no more; with 0 it never steps. The default takes a step for
     * as expensive as a start: neighbours are stepped to, gaps are not. Override it where starting is more expensive.
     */
    public val shadingStartCost: Int get() = 1
}

/** Returns this primitive, or an opaque one like it whose colours have alpha 1 if it is translucent. */
public fun Primitive.asOpaque(): Primitive = if (isTranslucent) OpaquePrimitive(this) else this

/**
 * Coherent shading: state that is carried from sample to sample along a row. Belongs to one thread.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4.
 */
public interface ShadingCursor {
    /** Goes to the next column. Cheap beside [shade]: [Primitive.shadingStartCost] says how much. */
    public fun step()

    /** Computes the colour at the current column; [fragment] has been moved there. */
    public fun shade(fragment: Fragment)
}

/** Gives a primitive's spans row by row, downward. Belongs to one thread. */
public fun interface SpanCursor {
    /** Replaces the contents of [spans] by the spans of the current row, then steps to the next row. */
    public fun next(spans: Spans)
}

/** The plain twin of every cursor: evaluates each row on its own. */
private class DirectCursor(private val primitive: Primitive, private var y: Int) : SpanCursor {
    override fun next(spans: Spans) {
        spans.clear()
        primitive.spans(y, spans)
        y++
    }
}
