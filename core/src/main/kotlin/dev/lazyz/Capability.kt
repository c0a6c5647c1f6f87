package dev.lazyz

/**
 * What a renderer promises beyond the picture. Whoever declares one is held to it by the conformance suite; what is not
 * declared is neither used nor tested.
 */
public enum class Capability {
    /** Shades each visible sample once and nothing else: shading calls = visible samples. */
    SHADES_ONLY_VISIBLE,

    /** Working memory does not grow with the number of rows of the raster. */
    CONSTANT_MEMORY,

    /** Hands out a row as soon as it is ready, before later rows are begun. */
    STREAMS_ROWS,

    /** Takes primitives one by one and does not keep them: memory does not grow with their number. */
    STREAMS_PRIMITIVES,

    /** Works on several threads, [RenderOptions.threads]. */
    PARALLEL,

    /** Blends translucent primitives in exact order of depth. */
    TRANSPARENCY,

    /** Keeps to [RenderOptions.memoryBudget]. */
    MEMORY_BUDGET,

    /** Shades late, and heeds [RenderOptions.coherence]. */
    COHERENCE,

    /** Lets the caller choose which fragments of a sample make its colour. */
    SELECTION,
}

/** How late shading moves from sample to sample; the colours are the same bits (see [ShadingCursor]). */
public enum class Coherence {
    /** Each colour is evaluated by itself. */
    DIRECT,

    /** Each colour is reached by steps from the last visible sample of the primitive on the row. */
    INCREMENTAL,

    /** A cost model chooses between the two, for each primitive and gap (see [Primitive.shadingStartCost]). */
    ADAPTIVE,
}
