package dev.lazyz.geometry

/** Which samples are inside a polygon whose contours overlap (contract rule 2.4). */
public enum class FillRule {
    /** A sample is inside if a ray from it to infinity crosses the contours an odd number of times. */
    EVEN_ODD,

    /** A sample is inside if its winding number is not zero. */
    NON_ZERO,
}
