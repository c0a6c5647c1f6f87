package dev.lazyz.filter

/**
 * How the samples around a pixel are weighted. The weight of a sample is the product of a weight for its column and one
 * for its row, so every filter is separable.
 *
 * @property radius how far from the centre of a pixel samples count, pixels
 */
public enum class PixelFilter(public val radius: Double) {
    /** All samples of the pixel, with equal weights. The fastest, and exact for areas. */
    BOX(0.5),

    /**
     * Mitchell and Netravali's cubic filter with B = C = 1/3: sharp. It has small negative weights, so next to a strong
     * edge there is a faint line. Source: "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988.
     */
    MITCHELL(2.0),

    /**
     * The window of Blackman and Harris, four terms: smooth, without negative weights. Source: F. Harris, "On the Use
     * of Windows for Harmonic Analysis with the Discrete Fourier Transform", Proceedings of the IEEE 66, 1978.
     */
    BLACKMAN_HARRIS(1.5),
    ;

    /** Returns the weight at [distance] from the centre, pixels; not normalised. */
    internal fun weight(distance: Double): Double {
        val x = StrictMath.abs(distance)
        return when (this) {
            BOX -> 1.0
            MITCHELL -> mitchell(x)
            BLACKMAN_HARRIS -> blackmanHarris(StrictMath.PI * x / radius)
        }
    }

    private fun mitchell(x: Double): Double = when {
        x < 1.0 -> (7.0 * x * x * x - 12.0 * x * x + 16.0 / 3.0) / 6.0
        x < 2.0 -> (-7.0 / 3.0 * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0) / 6.0
        else -> 0.0
    }

    private fun blackmanHarris(angle: Double): Double =
        if (angle >= StrictMath.PI) {
            0.0
        } else {
            0.35875 + 0.48829 * StrictMath.cos(angle) + 0.14128 * StrictMath.cos(2 * angle) +
                0.01168 * StrictMath.cos(3 * angle)
        }
}
