package dev.lazyz.conformance.slow

import dev.lazyz.world.material.Lobes

/** How light is reflected, each function by the text that it names, with the cosine to the light left out. */
internal object SlowLobes {
    /** D G / (4 |v.n| |l.n|) of appendix B.3.2. */
    fun ggx(n: Vec, l: Vec, v: Vec, h: Vec, roughness: Double): Double {
        val a2 = Math.pow(roughness, 4.0)
        val nl = n dot l
        val nv = n dot v
        val nh = n dot h
        if (nl <= 0 || nh <= 0) return 0.0
        fun shadow(c: Double) = 2 * Math.abs(c) / (Math.abs(c) + Math.sqrt(a2 + (1 - a2) * c * c))
        val d = a2 / (Math.PI * Math.pow(nh * nh * (a2 - 1) + 1, 2.0))
        return d * shadow(nl) * shadow(nv) / (4 * Math.abs(nv) * Math.abs(nl))
    }

    /**
     * `KHR_materials_anisotropy`: D of its text, and the masking and shadowing that follows from it as that of
     * appendix B.3.2 follows from its own. [t] is the direction of the longer highlights.
     */
    fun stretched(n: Vec, t: Vec, l: Vec, v: Vec, h: Vec, roughness: Double, strength: Double): Double {
        if ((n dot l) <= 0 || (n dot h) <= 0) return 0.0
        val b = n.cross(t)
        val across = roughness * roughness
        val along = across * (1 - strength * strength) + strength * strength
        fun shadow(d: Vec): Double {
            val cosine = Math.abs(n dot d)
            return 2 * cosine / (cosine + Vec(along * (t dot d), across * (b dot d), cosine).length())
        }
        val slopes = Vec((h dot t) / along, (h dot b) / across, h dot n)
        val d = 1 / (Math.PI * along * across * Math.pow(slopes dot slopes, 2.0))
        return d * shadow(l) * shadow(v) / (4 * Math.abs(n dot v) * (n dot l))
    }

    /** `KHR_materials_sheen`: the distribution "Charlie" with the simpler of both visibilities. */
    fun fibres(n: Vec, l: Vec, v: Vec, h: Vec, roughness: Double): Double {
        val nl = n dot l
        val nv = Math.abs(n dot v)
        val nh = n dot h
        if (nl <= 0) return 0.0
        val inverse = 1 / (roughness * roughness)
        val d = (2 + inverse) * Math.pow(Math.sqrt(Math.max(1 - nh * nh, 0.0)), inverse) / (2 * Math.PI)
        return d / (4 * (nl + nv - nl * nv))
    }

    /**
     * `KHR_materials_iridescence`: what a film on a surface with the reflectance [f0] reflects in one channel. The
     * text has a closed form for what an eye sees of a wave; here it is summed up over the spectrum, for each 500th
     * of the [cosine].
     */
    fun film(f0: Double, channel: Int, film: Lobes.Iridescence, cosine: Double): Double {
        val table = FILMS.getOrPut(Triple(f0, channel, film)) {
            DoubleArray(501) { reflected(f0, channel, film, it / 500.0) }
        }
        val place = Math.min(cosine, 1.0) * 500
        val left = Math.min(place.toInt(), 499)
        return table[left] + (table[left + 1] - table[left]) * (place - left)
    }

    private fun reflected(f0: Double, channel: Int, film: Lobes.Iridescence, cosine: Double): Double {
        fun between(a: Double, b: Double) = Math.pow((a - b) / (a + b), 2.0)
        fun fresnel(f: Double, c: Double) = f + (1 - f) * Math.pow(1 - c, 5.0)
        val index = film.refraction.toDouble()
        val inside = Math.sqrt(1 - (1 - cosine * cosine) / (index * index))
        val root = Math.sqrt(f0)
        val base = (1 + root) / (1 - root)
        val first = fresnel(between(index, 1.0), cosine)
        val second = fresnel(between(base, index), inside)
        val shift = Math.PI + if (base < index) Math.PI else 0.0
        val way = 2 * Math.PI * 2 * index * film.thickness * 1e-9 * inside

        // What comes back after any number of ways through the film, and how its first two orders interfere
        val again = (1 - first) * (1 - first) * second / (1 - first * second)
        val waves = (1..2).sumOf { order ->
            val amplitude = (again - (1 - first)) * Math.pow(first * second, order / 2.0)
            2 * amplitude * seen(channel) { Math.cos(order * (it * way + shift)) }
        }
        return Math.max(first + again + waves, 0.0)
    }

    /** What an eye sees of light whose part [left] is left by wave number, in units of white light. */
    private fun seen(channel: Int, left: (waveNumber: Double) -> Double): Double {
        val places = (-60..60).map { it / 10.0 }
        val all = places.sumOf { Math.exp(-it * it / 2) }
        return HUMPS.sumOf { (axis, place, width, area) ->
            val sum = places.sumOf { Math.exp(-it * it / 2) * left(place + it * Math.sqrt(2 * width)) }
            TO_RGB[3 * channel + axis.toInt()] * area * Math.sqrt(2 * Math.PI * width) * sum / all / WHITE
        }
    }

    private val FILMS = HashMap<Triple<Double, Int, Lobes.Iridescence>, DoubleArray>()
    private const val WHITE = 1.0685e-7

    /** Humps of the functions X, Y and Z: number, wave number of the middle, width and area, as in the text. */
    private val HUMPS = listOf(
        doubleArrayOf(0.0, 1.6810e6, 4.3278e9, 5.4856e-13), doubleArrayOf(0.0, 2.2399e6, 4.5282e9, 9.7470e-14),
        doubleArrayOf(1.0, 1.7953e6, 9.3046e9, 4.4201e-13), doubleArrayOf(2.0, 2.2084e6, 6.6121e9, 5.2481e-13),
    )

    /** From X, Y and Z to the primaries of BT.709, a row each. */
    private val TO_RGB = doubleArrayOf(
        3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252,
    )
}
