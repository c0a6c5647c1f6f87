package dev.lazyz

/**
 * A guarantee that a renderer gives in addition to the correct image. The conformance suite checks each declared
 * capability (contract rule 7.6). A capability that is not declared is neither used nor tested.
 */
public enum class Capability {
    /** Shades each visible sample exactly once, and nothing else: shading calls = visible samples. */
    SHADES_ONLY_VISIBLE,

    /** The amount of working memory does not depend on the number of rows of the raster. */
    CONSTANT_MEMORY,

    /** Passes each row to the sink as soon as it is complete, before work on later rows starts. */
    STREAMS_ROWS,

    /**
     * Reads primitives one by one and does not keep hidden ones: memory does not grow with their number.
     */
    STREAMS_PRIMITIVES,

    /** Uses several threads, up to [RenderOptions.threads]. */
    PARALLEL,

    /** Blends translucent primitives in exact depth order. */
    TRANSPARENCY,

    /** Limits its working memory to [RenderOptions.memoryBudget]. */
    MEMORY_BUDGET,

    /** Shades after visibility is known, and supports [RenderOptions.coherence]. */
    COHERENCE,

    /** Supports [RenderOptions.selector]: the caller chooses which fragments of a sample determine its colour. */
    SELECTION,
}
