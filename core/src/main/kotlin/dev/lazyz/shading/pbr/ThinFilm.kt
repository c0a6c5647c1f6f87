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

    /** Areas, places and widths of the colour matching functions X, Y and Z, and of the second hump of X. */
    private val PLACES = doubleArrayOf(1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6)
    private val WIDTHS = doubleArrayOf(4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9)
    private val AREAS = doubleArrayOf(5.4856e-13, 4.4201e-13, 5.2481e-13, 9.7470e-14).also {
        for (hump in it.indices) it[hump] *= StrictMath.sqrt(2.0 * StrictMath.PI * WIDTHS[hump])
    }
    private const val WHITE = 1.0685e-7
    private const val ORDERS = 2

    /** From X, Y and Z to red, green and blue, a row each. */
    private val TO_RGB = doubleArrayOf(
        3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252,
    )

    /**
     * Replaces the [part] of the reflectance at normal incidence, three numbers of [surface] from [at] on, by that
     * under a film of the index [refraction] and a [thickness] in nanometres, such that Schlick's formula gives what
     * the film reflects at the angle with the [cosine].
     */
    fun cover(surface: FloatArray, at: Int, part: Float, refraction: Float, thickness: Float, cosine: Float) {
        val film = Film(refraction.toDouble(), thickness.toDouble(), cosine.toDouble())
        for (channel in 0 until 3) {
            val f0 = surface[at + channel]
            val covered = if (thickness == 0f) f0 else film.reflectance(f0, channel)
            surface[at + channel] = f0 * (1f - part) + covered * part
        }
    }

    /** A film at an angle, with the functions that all channels share. Not thread safe. */
    private class Film(refraction: Double, thickness: Double, private val cosine: Double) {
        private val fade = Math.min(thickness / THIN, 1.0)
        private val index = 1.0 + (refraction - 1.0) * (fade * fade * (3.0 - 2.0 * fade))
        private val below = 1.0 - (1.0 - cosine * cosine) / (index * index)
        private val inside = if (below < 0.0) 0.0 else StrictMath.sqrt(below)
        private val upper = schlick(atNormal(index, 1.0), cosine)
        private val phases = DoubleArray(ORDERS) { order ->
            2.0 * StrictMath.PI * ((order + 1) * 2.0 * index * thickness * inside) * 1e-9
        }

        /** For each order and hump: its decay, and its wave with the shift of [shifts]. */
        private val decays = DoubleArray(ORDERS * AREAS.size)
        private val waves = DoubleArray(ORDERS * AREAS.size)
        private val shifts = DoubleArray(ORDERS) { Double.NaN }

        fun reflectance(f0: Float, channel: Int): Float {
            val grazing = Math.min(fifth(1.0 - cosine), MOST)
            return ((reflected(f0.toDouble(), channel) - grazing) / (1.0 - grazing)).coerceIn(0.0, 1.0).toFloat()
        }

        private fun reflected(f0: Double, channel: Int): Double {
            if (below < 0.0) return 1.0

            // The lower side, whose index follows from its reflectance
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
            for (order in 1..ORDERS) {
                amplitude *= StrictMath.sqrt(both)
                sum += amplitude * 2.0 * sensitivity(channel, order - 1, order * shift)
            }
            return Math.max(sum, 0.0)
        }

        /** Returns the Fourier transform of the sensitivity in [channel] at the optical path of an order. */
        private fun sensitivity(channel: Int, order: Int, shift: Double): Double {
            if (shift != shifts[order]) setWaves(order, shift)
            var sum = 0.0
            for (hump in AREAS.indices) {
                val at = order * AREAS.size + hump
                sum += TO_RGB[3 * channel + hump % 3] * (AREAS[hump] * waves[at] * decays[at])
            }
            return sum / WHITE
        }

        private fun setWaves(order: Int, shift: Double) {
            val phase = phases[order]
            val isFirst = shifts[order].isNaN()
            shifts[order] = shift
            for (hump in AREAS.indices) {
                val at = order * AREAS.size + hump
                waves[at] = StrictMath.cos(PLACES[hump] * phase + shift)
                if (isFirst) decays[at] = StrictMath.exp(-phase * phase * WIDTHS[hump])
            }
        }
    }

    private fun atNormal(lower: Double, upper: Double): Double {
        val part = (lower - upper) / (lower + upper)
        return part * part
    }

    private fun schlick(f0: Double, cosine: Double): Double = f0 + (1.0 - f0) * fifth(1.0 - cosine)

    private fun fifth(x: Double): Double = x * x * (x * x) * x
}
