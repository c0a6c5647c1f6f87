package dev.lazyz.shading.pbr

import kotlin.math.sqrt

/**
 * A rectangle that emits light, seen from its front, at an infinite distance. Immutable and thread safe.
 *
 * A direction that is not behind the box meets its plane, at distance 1, in a point with the coordinates (s, t) along
 * its sides. The light there, blurred by the microfacets of a surface, is
 * `(S((s + a) / w) - S((s - a) / w)) / 2`, times the same for t, where a is half the side and
 * `S(x) = x / sqrt(1 + x^2)`. S is the distribution of the slopes of GGX along one axis, so this is a blur by
 * microfacets of the width w, with the approximation that slopes along both axes are independent.
 *
 * @param toward the direction of its centre, of any length; its horizontal side is level
 * @property width half of its width at distance 1
 * @property height half of its height at distance 1
 * @property red light that it emits, linear
 */
internal class SoftBox(
    toward: DoubleArray,
    private val width: Float,
    private val height: Float,
    val red: Float,
    val green: Float,
    val blue: Float,
) {
    // The unit vectors to the centre, to the right and upward
    private val cx: Float
    private val cy: Float
    private val cz: Float
    private val sx: Float
    private val sz: Float
    private val tx: Float
    private val ty: Float
    private val tz: Float

    init {
        val (x, y, z) = toward
        val length = StrictMath.sqrt(x * x + y * y + z * z)
        val level = StrictMath.sqrt(x * x + z * z)
        cx = (x / length).toFloat()
        cy = (y / length).toFloat()
        cz = (z / length).toFloat()
        sx = (z / level).toFloat()
        sz = (-x / level).toFloat()
        tx = (-x / level * (y / length)).toFloat()
        ty = (level / length).toFloat()
        tz = (-z / level * (y / length)).toFloat()
    }

    /** Returns how much of the light that is blurred by [blur] from the unit vector (x, y, z) is of this box, 0..1. */
    fun coverage(x: Float, y: Float, z: Float, blur: Float): Float {
        val distance = cx * x + cy * y + cz * z
        if (!(distance > LEAST)) return 0f
        val s = (sx * x + sz * z) / distance
        val t = (tx * x + ty * y + tz * z) / distance
        return part(s, width, blur) * part(t, height, blur)
    }

    private fun part(at: Float, half: Float, blur: Float): Float =
        0.5f * (slope((at + half) / blur) - slope((at - half) / blur))

    private fun slope(x: Float): Float = x / sqrt(1f + x * x)

    private companion object {
        /** Directions nearer to the plane through the viewer are behind the box. */
        const val LEAST: Float = 0.01f
    }
}
