package dev.lazyz.scenes.meshes

import dev.lazyz.geometry.DistinctTriples

/** Numbers the distinct colours of a file from 0: red, green, blue in linear light, and alpha. Not thread safe. */
internal class Palette {
    /** Bits of red, green and blue. */
    private val opaque = DistinctTriples()

    /** For each colour: number in [opaque], and bits of alpha. */
    private val colors = DistinctTriples()

    /** Whether a colour is translucent. */
    var isTranslucent = false
        private set

    /** Returns the number of this colour, a new number if the colour is new. */
    fun add(red: Float, green: Float, blue: Float, alpha: Float): Int {
        if (alpha < 1f) isTranslucent = true
        return colors.add(opaque.add(red.toBits(), green.toBits(), blue.toBits()), alpha.toBits(), 0)
    }

    /** Writes the four components of colour [number] to [to], starting at index [at]. */
    fun copy(number: Int, to: FloatArray, at: Int) {
        val color = colors.get(number, 0)
        for (channel in 0 until 3) to[at + channel] = Float.fromBits(opaque.get(color, channel))
        to[at + 3] = Float.fromBits(colors.get(number, 1))
    }
}
