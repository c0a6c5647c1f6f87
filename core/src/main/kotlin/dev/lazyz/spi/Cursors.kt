package dev.lazyz.spi

/**
 * Incremental shading: carries state from sample to sample along a row. Used by one thread.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), section 4.
 */
public interface ShadingCursor {
    /**
     * Moves to the next column. Less expensive than a direct evaluation; `Primitive.shadingStartCost` gives the ratio.
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

/**
 * Observes the shading calls of a rendering: which samples are shaded, how often, and in which order. See
 * `Frame.observed`.
 *
 * It is called before a colour is computed, by the threads of the renderer, several at the same time if the renderer
 * uses several; so it must be thread safe, or the renderer be configured with one thread.
 */
public fun interface ShadingObserver {
    /** The primitive with the submission index [primitive] is about to be shaded at column [x] and row [y]. */
    public fun shading(x: Int, y: Int, primitive: Int)
}
