package dev.lazyz.conformance.oracle

/** What exact arithmetic says about one sample of a surface. */
public enum class Coverage {
    /** The surface covers the sample. */
    COVERED,

    /** The surface does not cover the sample. */
    UNCOVERED,

    /** The sample is so close to the outline that the contract lets rounding decide: either answer is right. */
    OPEN,
}

/**
 * A surface that is decided sample by sample, without set-up and without rounding: what oracles are made of.
 *
 * Implementations are immutable and thread safe.
 */
public interface ExactSurface {
    /** Whether the sample of column [x] and row [y] is covered. Never [Coverage.OPEN] for flat surfaces. */
    public fun coverage(x: Int, y: Int): Coverage

    /**
     * Returns how many units [depth] differs from the exact one at the covered sample of column [x] and row [y], 0 or
     * more. Contract rule 4.4 allows no more than 1.
     */
    public fun depthError(x: Int, y: Int, depth: Int): Double
}
