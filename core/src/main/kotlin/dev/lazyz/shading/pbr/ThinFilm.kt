package dev.lazyz.shading.pbr

/**
 * The colours of thin films, as on soap bubbles: light that both sides of the film reflect, and that interferes. In
 * double precision with [StrictMath].
 *
 * Sources: L. Belcour and P. Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying
 * Iridescence", 2017; the specification of `KHR_materials_iridescence`, Khronos Group.
 */
internal object ThinFilm {
    /** Films below this thickness, in nanometres, fade to none. */
    private const val THIN = 0.03
    private const val MOST = 0.9999
    private const val LEAST = 1e-5

    /** Heights, places and widths of the colour matching functions X, Y and Z, and of the second hump of X. */
    private val HEIGHTS = doubleArrayOf(5.4856e-13, 4.4201e-13, 5.2481e-13, 9.7470e-14)
    private val PLACES = doubleArrayOf(1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6)
    private val WIDTHS = doubleArrayOf(4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9)
    private const val WHITE = 1.0685e-7

    /** From X, Y and Z to red, green and blue, a row each. */
    private val TO_RGB = doubleArrayOf(
        3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252,
    )

    /**
     * Returns the reflectance at normal incidence, in [channel], of a surface with the reflectance [f0] under a film of
     * the index [refraction] and a [thickness] in nanometres, such that Schlick's formula gives what the film reflects
     * at the angle with the [cosine].
     */
    fun reflectance(f0: Float, channel: Int, refraction: Float, thickness: Float, cosine: Float): Float {
        if (thickness == 0f) return f0
        val grazing = Math.min(fifth(1.0 - cosine), MOST)
        val reflected =
            reflected(f0.toDouble(), channel, refraction.toDouble(), thickness.toDouble(), cosine.toDouble())
        return ((reflected - grazing) / (1.0 - grazing)).coerceIn(0.0, 1.0).toFloat()
    }

    private fun reflected(f0: Double, channel: Int, refraction: Double, thickness: Double, cosine: Double): Double {
        val fade = Math.min(thickness / THIN, 1.0)
        val index = 1.0 + (refraction - 1.0) * (fade * fade * (3.0 - 2.0 * fade))
        val below = 1.0 - (1.0 - cosine * cosine) / (index * index)
        if (below < 0.0) return 1.0
        val inside = StrictMath.sqrt(below)

        // The upper side, and the lower one, whose index follows from its reflectance
        val upper = schlick(atNormal(index, 1.0), cosine)
        val root = StrictMath.sqrt(f0.coerceIn(0.0, MOST))
        val base = (1.0 + root) / (1.0 - root)
        val lower = schlick(atNormal(base, index), inside)
        val shift = (if (index < 1.0) 0.0 else StrictMath.PI) + (if (base < index) StrictMath.PI else 0.0)

        // The sum of all reflections, of which two orders of interference are seen
        val both = (upper * lower).coerceIn(LEAST, MOST)
        val passed = 1.0 - upper
        val again = passed * passed * lower / (1.0 - both)
        var sum = upper + again
        var amplitude = again - passed
        for (order in 1..2) {
            amplitude *= StrictMath.sqrt(both)
            sum += amplitude * 2.0 * sensitivity(channel, order * 2.0 * index * thickness * inside, order * shift)
        }
        return Math.max(sum, 0.0)
    }

    /** Returns the Fourier transform of the sensitivity in [channel] at an optical path of [way] nanometres. */
    private fun sensitivity(channel: Int, way: Double, shift: Double): Double {
        val phase = 2.0 * StrictMath.PI * way * 1e-9
        var sum = 0.0
        for (hump in HEIGHTS.indices) {
            val part = HEIGHTS[hump] * StrictMath.sqrt(2.0 * StrictMath.PI * WIDTHS[hump]) *
                StrictMath.cos(PLACES[hump] * phase + shift) * StrictMath.exp(-phase * phase * WIDTHS[hump])
            sum += TO_RGB[3 * channel + hump % 3] * part
        }
        return sum / WHITE
    }

    private fun atNormal(lower: Double, upper: Double): Double {
        val part = (lower - upper) / (lower + upper)
        return part * part
    }

    private fun schlick(f0: Double, cosine: Double): Double = f0 + (1.0 - f0) * fifth(1.0 - cosine)

    private fun fifth(x: Double): Double = x * x * (x * x) * x
}
