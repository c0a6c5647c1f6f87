package dev.lazyz

/**
 * Depth as every frame stores it: 31-bit fixed point, 0..2^31-1 (contract rule 4).
 *
 * What a camera sees lies in [NEAR]..[FAR]; the margins on both sides keep rounding, and the planes of polygons that
 * are not quite flat, from leaving the range.
 */
public object Depth {
    /** Units on each side of the range that no vertex has: 2^24, less than one percent of all. */
    public const val MARGIN: Int = 1 shl 24

    /** Depth of the near plane. */
    public const val NEAR: Int = MARGIN

    /** Depth of the far plane. */
    public const val FAR: Int = Int.MAX_VALUE - MARGIN

    /** Returns the depth at [unit] of the way from the near plane (0) to the far plane (1), rounded; clamped to both. */
    @JvmStatic
    public fun ofUnit(unit: Double): Int =
        Math.rint(NEAR + unit.coerceIn(0.0, 1.0) * (FAR.toDouble() - NEAR)).toInt()

    /** Returns where [depth] lies between the near plane (0) and the far plane (1); outside 0..1 within the margins. */
    @JvmStatic
    public fun toUnit(depth: Int): Double = (depth.toDouble() - NEAR) / (FAR.toDouble() - NEAR)
}
