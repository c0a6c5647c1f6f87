package dev.lazyz.geometry

/** Which samples are inside a polygon whose contours overlap (contract rule 2.4). */
public enum class FillRule {
    /** A sample is inside if a ray from it to infinity crosses the contours an odd number of times. */
    EVEN_ODD,

    /** A sample is inside if its winding number is not zero. */
    NON_ZERO,
    ;

    /** Whether a point is inside if [windings] is the sum of the windings of the crossings on one side of it. */
    internal fun isInside(windings: Int): Boolean = if (this == EVEN_ODD) windings and 1 != 0 else windings != 0
}
