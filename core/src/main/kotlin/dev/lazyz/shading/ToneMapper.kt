package dev.lazyz.shading

import dev.lazyz.world.light.ToneMapping

/**
 * Applies exposure and a tone curve to a colour (contract rule 6.11). Immutable and thread safe.
 *
 * Sources: K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016, for [ToneMapping.Curve.ACES]; Khronos Group, "PBR
 * Neutral Tone Mapper Specification", 2024, for [ToneMapping.Curve.NEUTRAL].
 */
internal class ToneMapper private constructor(private val curve: ToneMapping.Curve, private val factor: Float) {
    /** Replaces red, green and blue, in 0..2 of [color]. */
    fun apply(color: FloatArray) {
        for (channel in 0 until 3) color[channel] *= factor
        when (curve) {
            ToneMapping.Curve.NONE -> Unit
            ToneMapping.Curve.ACES -> for (channel in 0 until 3) color[channel] = film(color[channel])
            ToneMapping.Curve.NEUTRAL -> neutral(color)
        }
    }

    private fun film(x: Float): Float {
        val light = if (x > 0f) minOf(x, MOST) else 0f
        return light * (2.51f * light + 0.03f) / (light * (2.43f * light + 0.59f) + 0.14f)
    }

    private fun neutral(color: FloatArray) {
        // Subtract what a dielectric reflects at normal incidence
        for (channel in 0 until 3) color[channel] = if (color[channel] > 0f) minOf(color[channel], MOST) else 0f
        val least = minOf(color[0], color[1], color[2])
        val offset = if (least < 2f * REFLECTANCE) least - 6.25f * least * least else REFLECTANCE
        for (channel in 0 until 3) color[channel] -= offset

        // Compress the largest component, and the others by the same factor; then approach white
        val peak = maxOf(color[0], color[1], color[2])
        if (peak < START) return
        val room = 1f - START
        val compressed = 1f - room * room / (peak + room - START)
        val white = 1f - 1f / (DESATURATION * (peak - compressed) + 1f)
        for (channel in 0 until 3) {
            val scaled = color[channel] * (compressed / peak)
            color[channel] = scaled + (compressed - scaled) * white
        }
    }

    companion object {
        private const val REFLECTANCE = 0.04f
        private const val START = 0.8f - REFLECTANCE
        private const val DESATURATION = 0.15f

        /** Brighter light, which would make infinity minus infinity, gives the same colour. */
        private const val MOST = 1e9f

        /** Returns the mapper for [mapping], or null if it changes nothing. */
        fun of(mapping: ToneMapping): ToneMapper? = if (mapping == ToneMapping.NONE) {
            null
        } else {
            ToneMapper(mapping.curve, StrictMath.pow(2.0, mapping.exposure).toFloat())
        }
    }
}
