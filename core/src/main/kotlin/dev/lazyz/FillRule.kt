package dev.lazyz

/** Which samples lie inside a polygon whose contours overlap (contract rule 2.4). */
public enum class FillRule {
    /** Those from which a ray to infinity crosses the contours an odd number of times. */
    EVEN_ODD,

    /** Those that the contours wind around, by direction, not zero times. */
    NON_ZERO,
}
