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

    /** Colours computed, by [Primitive.shade] or [ShadingCursor.shade]. */
    @JvmField
    public var shadingCalls: Long = 0

    /** Shading calls whose attributes were evaluated at the sample, not reached by steps. Late shading only. */
    @JvmField
    public var shadingStarts: Long = 0

    /** Steps of incremental shading, from a column to the next. */
    @JvmField
    public var shadingSteps: Long = 0

    /** Most steps of incremental shading that one shading call had to make up for. */
    @JvmField
    public var longestChain: Long = 0

    /** Most suspended shading calls alive at one time. */
    @JvmField
    public var peakSuspensions: Long = 0

    /**
     * Bytes of working memory at its peak: what the renderer itself held, by the size of its arrays; neither the frame
     * nor the target of the rows.
     */
    @JvmField
    public var peakBytes: Long = 0

    /** Returns the work of this and [other] together, one done after the other: sums, and the greater of peaks. */
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
