package dev.lazyz

import dev.lazyz.spi.ShadingCursor

/**
 * Work that a renderer did, in units that have the same meaning for every renderer (contract rule 8). Immutable.
 *
 * A renderer counts in a [Builder].
 *
 * @property primitives submitted primitives, including those that cover no sample
 * @property fragments covered samples of the region, counted once for each primitive that covers them. Primitives that
 *   are rejected as hidden before their samples are determined are not counted, nor are those of a pass that only
 *   looks for hidden primitives
 * @property depthEvaluations depth computations, by a step or directly
 * @property depthPasses fragments that passed the depth test when they were compared. A renderer that first
 *   collects all fragments counts one for each sample
 * @property shadingCalls colour computations, by [Primitive.shade] or [ShadingCursor.shade]
 * @property shadingStarts shading calls that evaluated the attributes at the sample instead of stepping to it. Late
 *   shading only
 * @property shadingSteps steps of incremental shading; one step moves one column
 * @property longestChain the largest number of incremental steps before a single shading call
 * @property peakSuspensions the largest number of shading calls that were pending at the same time
 * @property peakBytes peak working memory of the renderer, in bytes: the size of its arrays, without the frame and
 *   without the memory of the row sink; with several threads it may differ from run to run, as the threads share the
 *   work in another way each time
 */
public class Counters private constructor(
    public val primitives: Long,
    public val fragments: Long,
    public val depthEvaluations: Long,
    public val depthPasses: Long,
    public val shadingCalls: Long,
    public val shadingStarts: Long,
    public val shadingSteps: Long,
    public val longestChain: Long,
    public val peakSuspensions: Long,
    public val peakBytes: Long,
) {
    /**
     * Returns the work of this and [other] together, when one runs after the other. Counts are added; [longestChain],
     * [peakSuspensions] and [peakBytes] are the larger of both.
     */
    public fun plus(other: Counters): Counters = toBuilder().add(other).build()

    /** Returns a builder with these numbers. */
    public fun toBuilder(): Builder = Builder().add(this)

    private fun all(): List<Long> = listOf(
        primitives, fragments, depthEvaluations, depthPasses, shadingCalls, shadingStarts, shadingSteps, longestChain,
        peakSuspensions, peakBytes,
    )

    override fun equals(other: Any?): Boolean = other is Counters && all() == other.all()

    override fun hashCode(): Int = all().hashCode()

    override fun toString(): String =
        "Counters(primitives=$primitives, fragments=$fragments, depthEvaluations=$depthEvaluations, " +
            "depthPasses=$depthPasses, shadingCalls=$shadingCalls, shadingStarts=$shadingStarts, " +
            "shadingSteps=$shadingSteps, longestChain=$longestChain, peakSuspensions=$peakSuspensions, " +
            "peakBytes=$peakBytes)"

    /**
     * Counts while a renderer works. The fields are those of [Counters], and start at 0. Not thread safe: each thread
     * counts in a builder of its own, and the results are added.
     */
    public class Builder {
        /** See [Counters.primitives]. */
        @JvmField
        public var primitives: Long = 0

        /** See [Counters.fragments]. */
        @JvmField
        public var fragments: Long = 0

        /** See [Counters.depthEvaluations]. */
        @JvmField
        public var depthEvaluations: Long = 0

        /** See [Counters.depthPasses]. */
        @JvmField
        public var depthPasses: Long = 0

        /** See [Counters.shadingCalls]. */
        @JvmField
        public var shadingCalls: Long = 0

        /** See [Counters.shadingStarts]. */
        @JvmField
        public var shadingStarts: Long = 0

        /** See [Counters.shadingSteps]. */
        @JvmField
        public var shadingSteps: Long = 0

        /** See [Counters.longestChain]. */
        @JvmField
        public var longestChain: Long = 0

        /** See [Counters.peakSuspensions]. */
        @JvmField
        public var peakSuspensions: Long = 0

        /** See [Counters.peakBytes]. */
        @JvmField
        public var peakBytes: Long = 0

        /** Adds the work of [other], as [Counters.plus] does. */
        public fun add(other: Counters): Builder = apply {
            primitives += other.primitives
            fragments += other.fragments
            depthEvaluations += other.depthEvaluations
            depthPasses += other.depthPasses
            shadingCalls += other.shadingCalls
            shadingStarts += other.shadingStarts
            shadingSteps += other.shadingSteps
            longestChain = maxOf(longestChain, other.longestChain)
            peakSuspensions = maxOf(peakSuspensions, other.peakSuspensions)
            peakBytes = maxOf(peakBytes, other.peakBytes)
        }

        /** Returns the work so far. The builder can be used further. */
        public fun build(): Counters = Counters(
            primitives, fragments, depthEvaluations, depthPasses, shadingCalls, shadingStarts, shadingSteps,
            longestChain, peakSuspensions, peakBytes,
        )

        override fun toString(): String = build().toString()
    }

    public companion object {
        /** No work. */
        @JvmField
        public val NONE: Counters = Builder().build()
    }
}
