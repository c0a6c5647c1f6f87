package dev.lazyz.world.light

/** Light by direction, in a space of its own in which y points up. Immutable and thread safe. */
internal interface Surroundings {
    /**
     * Stores the light around the unit vector (x, y, z), as a surface of a perceptual [roughness], 0..1, reflects it,
     * in [out] at [at] and the two elements after it.
     */
    fun radiance(x: Float, y: Float, z: Float, roughness: Float, out: FloatArray, at: Int)

    /** Stores the mean light that a matt surface with the unit normal (x, y, z) receives in [out]. */
    fun irradiance(x: Float, y: Float, z: Float, out: FloatArray, at: Int)
}

/**
 * The light that matt surfaces receive, by their normals: the first nine spherical harmonics of light from all sides,
 * times what a cosine keeps of them. R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance
 * Environment Maps", SIGGRAPH 2001. Not thread safe until the last [finish].
 */
internal class Irradiance {
    private val sums = Array(3) { DoubleArray(COUNT) }
    private val coefficients = Array(3) { FloatArray(COUNT) }

    /** Adds a part [weight] of the sphere at the unit vector (x, y, z), with the red, green and blue [light]. */
    fun add(x: Double, y: Double, z: Double, weight: Double, light: (channel: Int) -> Double) {
        val basis = doubleArrayOf(1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y)
        for (channel in 0 until 3) for (k in 0 until COUNT) sums[channel][k] += weight * light(channel) * basis[k]
    }

    /** Computes the coefficients from what was added: [all] is the sum of the weights. */
    fun finish(all: Double) {
        for (channel in 0 until 3) {
            for (k in 0 until COUNT) {
                coefficients[channel][k] = (sums[channel][k] / all * NORMS[k] * KEPT[k]).toFloat()
            }
        }
    }

    /** See [Surroundings.irradiance]. */
    fun at(x: Float, y: Float, z: Float, out: FloatArray, at: Int) {
        for (channel in 0 until 3) {
            val sum = sum(coefficients[channel], x, y, z)
            out[at + channel] = if (sum > 0f) sum else 0f
        }
    }

    private fun sum(h: FloatArray, x: Float, y: Float, z: Float): Float =
        h[0] + h[1] * y + h[2] * z + h[3] * x + h[4] * (x * y) + h[5] * (y * z) +
            h[6] * (3f * z * z - 1f) + h[7] * (x * z) + h[8] * (x * x - y * y)

    private companion object {
        const val COUNT = 9

        /** 1 / mean of the square of each function over the sphere. */
        val NORMS = doubleArrayOf(1.0, 3.0, 3.0, 3.0, 15.0, 15.0, 1.25, 15.0, 3.75)

        /** What the cosine of a matt surface keeps of the functions of degree 0, 1 and 2. */
        const val TWO_THIRDS = 2.0 / 3.0
        val KEPT = doubleArrayOf(1.0, TWO_THIRDS, TWO_THIRDS, TWO_THIRDS, 0.25, 0.25, 0.25, 0.25, 0.25)
    }
}
