package dev.lazyz.shading.pbr

import dev.lazyz.world.light.Irradiance
import dev.lazyz.world.light.Surroundings
import kotlin.math.sqrt

/**
 * The light of the studio by direction (contract rule 6.10): walls that are darker below, and soft boxes. In its space,
 * y points up, and z to the side on which the viewer is.
 */
internal object Studio : Surroundings {
    private val boxes: Array<SoftBox> = arrayOf(
        // Key light at the upper left, fill light at the right, above, and behind at the left and at the right; and a
        // dim light at the camera, which is what black glossy surfaces show where they face it
        SoftBox(doubleArrayOf(-0.75, 0.70, 0.75), 0.55f, 0.50f, 3.1f, 3.0f, 2.9f),
        SoftBox(doubleArrayOf(1.0, 0.20, 0.45), 0.28f, 0.75f, 1.35f, 1.4f, 1.45f),
        SoftBox(doubleArrayOf(0.05, 1.0, -0.1), 0.70f, 0.45f, 1.35f, 1.35f, 1.35f),
        SoftBox(doubleArrayOf(-0.9, 0.25, -0.8), 0.30f, 0.70f, 1.8f, 1.85f, 1.95f),
        SoftBox(doubleArrayOf(0.8, 0.35, -0.9), 0.35f, 0.60f, 1.4f, 1.4f, 1.4f),
        SoftBox(doubleArrayOf(-0.10, 0.12, 1.0), 0.42f, 0.34f, 0.62f, 0.62f, 0.62f),
    )

    /** The light of the walls: of the horizon, how it rises upward, and how it bends. */
    private const val HORIZON = 0.30f
    private const val RISE = 0.12f
    private const val BEND = 0.04f

    private val irradiance = Irradiance()

    init {
        integrate()
    }

    /**
     * For the roughness 1, the blur is that of a matt surface, exactly: the irradiance. For smaller ones, it is a mean
     * of this, with the weight alpha, and of the light of walls and boxes blurred one by one. Compared with the
     * integral over the reflected light, in which each direction has the weight of its cosine, the root mean square of
     * the difference is at most 0.13; the light is 0.7 on average.
     */
    override fun radiance(x: Float, y: Float, z: Float, roughness: Float, out: FloatArray, at: Int) {
        val alpha = roughness * roughness
        irradiance(x, y, z, out, at)
        val wall = wall(y, alpha)
        for (channel in 0 until 3) out[at + channel] = alpha * out[at + channel] + (1f - alpha) * wall
        if (alpha == 1f) return
        val blur = blur(alpha)
        for (box in boxes) {
            val part = (1f - alpha) * box.coverage(x, y, z, blur)
            out[at] += part * box.red
            out[at + 1] += part * box.green
            out[at + 2] += part * box.blue
        }
    }

    override fun irradiance(x: Float, y: Float, z: Float, out: FloatArray, at: Int) = irradiance.at(x, y, z, out, at)

    /** Returns the light of the walls around a direction, blurred by microfacets of the width [alpha]. */
    private fun wall(y: Float, alpha: Float): Float =
        HORIZON + RISE * (1f - alpha / 3f) * y + BEND * (1f - 0.75f * alpha) * (y * y - THIRD)

    /** Returns the width by which the light of a box, which has soft edges itself, is blurred. */
    private fun blur(alpha: Float): Float {
        val narrow = alpha * NARROW / (1f + 2.6f * alpha)
        return sqrt(EDGE * EDGE + narrow * narrow)
    }

    private fun integrate() {
        val light = FloatArray(3)
        for (row in 0 until ROWS) {
            val y = 1.0 - (2.0 * row + 1.0) / ROWS
            val level = StrictMath.sqrt(1.0 - y * y)
            for (column in 0 until COLUMNS) {
                val angle = 2.0 * StrictMath.PI * (column + 0.5) / COLUMNS
                val x = level * StrictMath.cos(angle)
                val z = level * StrictMath.sin(angle)
                radiance(x.toFloat(), y.toFloat(), z.toFloat(), 0f, light, 0)
                irradiance.add(x, y, z, 1.0) { light[it].toDouble() }
            }
        }
        irradiance.finish(ROWS * COLUMNS.toDouble())
    }

    private const val ROWS = 64
    private const val COLUMNS = 128

    /** Width of the soft edge of the boxes: so wide that mirrors do not show where they end. */
    private const val EDGE = 0.2f
    private const val THIRD = 1f / 3f

    /** Width of a narrow blur, divided by alpha: its peak is that of the reflected light, `sqrt(pi)`. */
    private const val NARROW = 1.772f
}

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
private class SoftBox(
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
