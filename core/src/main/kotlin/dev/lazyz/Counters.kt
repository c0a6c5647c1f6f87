package dev.lazyz

/**
 * Work that a renderer did, in units that have the same meaning for every renderer (contract rule 8).
 *
 * The renderer updates the counters while it works; the caller reads them afterwards. Not thread safe.
 */
public class Counters {
    /** Submitted primitives, including those that cover no sample. */
    @JvmField
    public var primitives: Long = 0

    /**
     * Covered samples of the region, counted once for each primitive that covers them. Primitives that are rejected as
     * hidden before their samples are determined are not counted.
     */
    @JvmField
    public var fragments: Long = 0

    /** Depth computations, by a step or directly. */
    @JvmField
    public var depthEvaluations: Long = 0

    /** Fragments that were the visible fragment of their sample at the time they were compared. */
    @JvmField
    public var depthPasses: Long = 0

    /** Colour computations, by [Primitive.shade] or [ShadingCursor.shade]. */
    @JvmField
    public var shadingCalls: Long = 0

    /** Shading calls that evaluated the attributes at the sample instead of stepping to it. Late shading only. */
    @JvmField
    public var shadingStarts: Long = 0

    /** Steps of incremental shading; one step moves one column. */
    @JvmField
    public var shadingSteps: Long = 0

    /** The largest number of incremental steps before a single shading call. */
    @JvmField
    public var longestChain: Long = 0

    /** The largest number of shading calls that were pending at the same time. */
    @JvmField
    public var peakSuspensions: Long = 0

    /**
     * Peak working memory of the renderer, in bytes: the size of its arrays, without the frame and without the memory
     * of the row sink.
     */
    @JvmField
    public var peakBytes: Long = 0

    /**
     * Returns the work of this and [other] together, when one runs after the other. Counts are added; [longestChain],
     * [peakSuspensions] and [peakBytes] are the larger of both.
     */
    public fun plus(other: Counters): Counters {
        val sum = Counters()
        sum.primitives = primitives + other.primitives
        sum.fragments = fragments + other.fragments
        sum.depthEvaluations = depthEvaluations + other.depthEvaluations
        sum.depthPasses = depthPasses + other.depthPasses
        sum.shadingCalls = shadingCalls + other.shadingCalls
        sum.shadingStarts = shadingStarts + other.shadingStarts
        sum.shadingSteps = shadingSteps + other.shadingSteps
        sum.longestChain = maxOf(longestChain, other.longestChain)
        sum.peakSuspensions = maxOf(peakSuspensions, other.peakSuspensions)
        sum.peakBytes = maxOf(peakBytes, other.peakBytes)
        return sum
    }

    override fun toString(): String =
        "Counters(primitives=$primitives, fragments=$fragments, depthEvaluations=$depthEvaluations, " +
            "depthPasses=$depthPasses, shadingCalls=$shadingCalls, shadingStarts=$shadingStarts, " +
            "shadingSteps=$shadingSteps, longestChain=$longestChain, peakSuspensions=$peakSuspensions, " +
            "peakBytes=$peakBytes)"
}
