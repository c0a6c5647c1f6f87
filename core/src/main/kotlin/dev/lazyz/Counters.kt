package dev.lazyz

/**
 * What a renderer did, in terms that mean the same for every renderer (contract rule 8).
 *
 * A renderer fills one in while it works; the caller reads it afterwards. Not thread safe.
 */
public class Counters {
    /** Primitives that were submitted, those that cover nothing included. */
    @JvmField
    public var primitives: Long = 0

    /** Covered samples, counted once for each primitive that covers them. */
    @JvmField
    public var fragments: Long = 0

    /** Times a depth was computed, by a step or directly. */
    @JvmField
    public var depthEvaluations: Long = 0

    /** Fragments that were the visible one of their sample at the time they were compared. */
    @JvmField
    public var depthPasses: Long = 0

    /** Calls of [Primitive.shade]. */
    @JvmField
    public var shadingCalls: Long = 0

    /** Steps of incremental shading. */
    @JvmField
    public var shadingSteps: Long = 0

    /** Most suspended shading calls alive at one time. */
    @JvmField
    public var peakSuspensions: Long = 0

    /**
     * Bytes of working memory at its peak: what the renderer itself held, by the size of its arrays; neither the frame
     * nor the target of the rows.
     */
    @JvmField
    public var peakBytes: Long = 0

    override fun toString(): String =
        "Counters(primitives=$primitives, fragments=$fragments, depthEvaluations=$depthEvaluations, " +
            "depthPasses=$depthPasses, shadingCalls=$shadingCalls, shadingSteps=$shadingSteps, " +
            "peakSuspensions=$peakSuspensions, peakBytes=$peakBytes)"
}
