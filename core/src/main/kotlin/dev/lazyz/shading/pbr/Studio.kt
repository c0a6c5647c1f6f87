package dev.lazyz.shading.pbr

/**
 * The light of the studio by direction (contract rule 6.10): walls that are darker below, and soft boxes. In its space,
 * y points up, and z to the side on which the viewer is.
 *
 * [radiance] is what a surface of a given roughness reflects from around a direction, and [irradiance] what a matt
 * surface receives. The latter uses the first nine spherical harmonics of the light, computed once: R. Ramamoorthi and
 * P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001.
 */
internal object Studio {
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

    /** Nine coefficients of the irradiance for red, green and blue. */
    private val harmonics: Array<FloatArray> = Array(3) { FloatArray(9) }

    init {
        integrate()
    }

    /**
     * Stores the light around the unit vector (x, y, z), blurred by microfacets of the width [alpha], in [out] at
     * [at] and the two elements after it.
     *
     * For alpha 1, the blur is that of a matt surface, exactly: [irradiance]. For smaller ones, it is a mean of this,
     * with the weight alpha, and of the light of walls and boxes blurred one by one. Compared with the integral over
     * the reflected light, in which each direction has the weight of its cosine, the root mean square of the difference
     * is at most 0.13; the light is 0.7 on average.
     */
    fun radiance(x: Float, y: Float, z: Float, alpha: Float, out: FloatArray, at: Int) {
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

    /** Stores the mean light that a matt surface with the unit normal (x, y, z) receives in [out]. */
    fun irradiance(x: Float, y: Float, z: Float, out: FloatArray, at: Int) {
        for (channel in 0 until 3) {
            val sum = sum(harmonics[channel], x, y, z)
            out[at + channel] = if (sum > 0f) sum else 0f
        }
    }

    /** Returns the light of the walls around a direction, blurred by microfacets of the width [alpha]. */
    private fun wall(y: Float, alpha: Float): Float =
        HORIZON + RISE * (1f - alpha / 3f) * y + BEND * (1f - 0.75f * alpha) * (y * y - THIRD)

    /** Returns the width by which the light of a box is blurred. */
    private fun blur(alpha: Float): Float = EDGE + alpha * NARROW / (1f + 2.6f * alpha)

    /** Returns the sum of the nine spherical harmonics with the coefficients [h] in the direction (x, y, z). */
    private fun sum(h: FloatArray, x: Float, y: Float, z: Float): Float =
        h[0] + h[1] * y + h[2] * z + h[3] * x + h[4] * (x * y) + h[5] * (y * z) +
            h[6] * (3f * z * z - 1f) + h[7] * (x * z) + h[8] * (x * x - y * y)

    private fun integrate() {
        val sums = Array(3) { DoubleArray(9) }
        val light = FloatArray(3)
        for (row in 0 until ROWS) {
            val y = 1.0 - (2.0 * row + 1.0) / ROWS
            val level = StrictMath.sqrt(1.0 - y * y)
            for (column in 0 until COLUMNS) {
                val angle = 2.0 * StrictMath.PI * (column + 0.5) / COLUMNS
                val x = level * StrictMath.cos(angle)
                val z = level * StrictMath.sin(angle)
                radiance(x.toFloat(), y.toFloat(), z.toFloat(), 0f, light, 0)
                val basis = doubleArrayOf(
                    1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y,
                )
                for (channel in 0 until 3) for (k in 0 until 9) sums[channel][k] += light[channel] * basis[k]
            }
        }

        // The mean over the sphere, by the squared norm of each function, and by what a matt surface keeps of it
        for (channel in 0 until 3) {
            for (k in 0 until 9) {
                harmonics[channel][k] = (sums[channel][k] / (ROWS * COLUMNS) * NORMS[k] * KEPT[k]).toFloat()
            }
        }
    }

    private const val ROWS = 64
    private const val COLUMNS = 128

    /** Width of the soft edge of the boxes. */
    private const val EDGE = 0.03f
    private const val THIRD = 1f / 3f

    /** Width of a narrow blur, divided by alpha: its peak is that of the reflected light, `sqrt(pi)`. */
    private const val NARROW = 1.772f

    /** 1 / mean of the square of each function over the sphere. */
    private val NORMS get() = doubleArrayOf(1.0, 3.0, 3.0, 3.0, 15.0, 15.0, 1.25, 15.0, 3.75)

    /** What the cosine of a matt surface keeps of the functions of degree 0, 1 and 2. */
    private val KEPT get() = doubleArrayOf(1.0, TWO_THIRDS, TWO_THIRDS, TWO_THIRDS, 0.25, 0.25, 0.25, 0.25, 0.25)
    private const val TWO_THIRDS = 2.0 / 3.0
}
