package dev.lazyz.conformance.oracle

/** Coverage of one sample by a surface in exact arithmetic. */
public enum class Coverage {
    /** The surface covers the sample. */
    COVERED,

    /** The surface does not cover the sample. */
    UNCOVERED,

    /** The sample is so close to the outline that the contract permits rounding to decide: both results are correct. */
    OPEN,
}

/**
 * A surface that is evaluated sample by sample, without set-up and without rounding. Oracles consist of such surfaces.
 *
 * Implementations are immutable and thread safe.
 */
public interface ExactSurface {
    /** Returns the coverage of the sample of column [x] and row [y]. Never [Coverage.OPEN] for flat surfaces. */
    public fun coverage(x: Int, y: Int): Coverage

    /**
     * Returns the absolute difference of [depth] from the exact depth at the covered sample of column [x] and row [y],
     * in units. Contract rule 4.4 permits at most 1.
     */
    public fun depthError(x: Int, y: Int, depth: Int): Double
}
