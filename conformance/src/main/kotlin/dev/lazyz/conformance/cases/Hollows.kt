package dev.lazyz.conformance.cases

import dev.lazyz.world.light.AmbientVisibility

/**
 * A visibility of ambient light that depends on all coordinates of the point and of the normal, and on nothing else:
 * a linear function of both, clamped to 0..1.
 *
 * Among the suite's surfaces, which are within a few units of the origin, it has all values from 0 to 1; a part of the
 * points has exactly 0, and another exactly 1. Immutable and thread safe.
 *
 * @param seed its six lowest bits are the signs of the six factors
 */
public class Hollows(private val seed: Int) : AmbientVisibility {
    override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float {
        val place = signed(0, x) + signed(1, y) + signed(2, z)
        val side = signed(3, normalX) + signed(4, normalY) + signed(5, normalZ)
        val sum = 0.5f + place * PLACE + side * SIDE
        return if (sum > 0f) minOf(sum, 1f) else 0f
    }

    private fun signed(bit: Int, value: Float): Float = if (seed ushr bit and 1 == 0) value else -value

    override fun toString(): String = "Hollows($seed)"

    private companion object {
        const val PLACE = 0.125f
        const val SIDE = 0.25f
    }
}
