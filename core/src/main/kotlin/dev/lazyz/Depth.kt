package dev.lazyz

/**
 * Depth values as every frame stores them: 31-bit fixed point, 0..2^31-1 (contract rule 4).
 *
 * What a camera sees is in [NEAR]..[FAR]. The margins outside that range absorb rounding errors, and the planes of
 * polygons that are not exactly flat.
 */
public object Depth {
    /**
     * Size of the margin at each end of the range, which no vertex uses: 2^24 units, less than one percent of the
     * range.
     */
    public const val MARGIN: Int = 1 shl 24

    /** Depth of the near plane. */
    public const val NEAR: Int = MARGIN

    /** Depth of the far plane. */
    public const val FAR: Int = Int.MAX_VALUE - MARGIN

    /**
     * Returns the depth at the fraction [unit] of the way from the near plane (0) to the far plane (1), rounded to
     * nearest. [unit] is clamped to 0..1; NaN counts as 1, behind everything else.
     */
    @JvmStatic
    public fun ofUnit(unit: Double): Int =
        if (unit < 1.0) Math.rint(NEAR + maxOf(unit, 0.0) * (FAR.toDouble() - NEAR)).toInt() else FAR

    /**
     * Returns where [depth] is between the near plane (0) and the far plane (1). The result is outside 0..1 for depths
     * in the margins.
     */
    @JvmStatic
    public fun toUnit(depth: Int): Double = (depth.toDouble() - NEAR) / (FAR.toDouble() - NEAR)
}
