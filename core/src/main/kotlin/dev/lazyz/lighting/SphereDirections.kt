package dev.lazyz.lighting

import org.joml.Vector3d

/**
 * Directions that are spread evenly: a spiral around the y axis, with turns of the golden angle.
 *
 * Source: R. Swinbank and R. J. Purser, "Fibonacci Grids", Quarterly Journal of the Royal Meteorological Society 132
 * (2006).
 */
internal object SphereDirections {
    /** Returns [count] unit vectors, as many in each part of the sphere. */
    fun everywhere(count: Int): List<Vector3d> = spiral(count) { 1.0 - 2.0 * it }

    /**
     * Returns [count] unit vectors that point up, and more of them the steeper they are: their number in a part of the
     * sphere is proportional to the seventh power of y.
     */
    fun above(count: Int): List<Vector3d> =
        spiral(count) { StrictMath.sqrt(StrictMath.sqrt(StrictMath.sqrt(1.0 - it))) }

    /** Returns the vectors whose y are those of [height] at evenly spaced places between 0 and 1. */
    private inline fun spiral(count: Int, height: (place: Double) -> Double): List<Vector3d> = List(count) { i ->
        val y = height((i + 0.5) / count)
        val level = StrictMath.sqrt(1.0 - y * y)
        Vector3d(level * StrictMath.cos(GOLDEN_ANGLE * i), y, level * StrictMath.sin(GOLDEN_ANGLE * i))
    }

    /** Radians. */
    private val GOLDEN_ANGLE = StrictMath.PI * (3.0 - StrictMath.sqrt(5.0))
}
