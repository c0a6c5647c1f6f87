package dev.lazyz.conformance.oracle

import dev.lazyz.world.light.ToneMapping

/** Exposure and tone curves as contract rule 6.11 defines them, in double precision. */
internal class ExactToneMapping(private val mapping: ToneMapping) {
    /** Returns red, green and blue as the picture shows them. */
    fun of(light: DoubleArray): DoubleArray {
        if (mapping == ToneMapping.NONE) return light
        val exposed = DoubleArray(3) { light[it] * Math.pow(2.0, mapping.exposure) }
        return when (mapping.curve) {
            ToneMapping.Curve.NONE -> exposed
            ToneMapping.Curve.ACES -> DoubleArray(3) { film(maxOf(0.0, exposed[it])) }
            ToneMapping.Curve.NEUTRAL -> neutral(DoubleArray(3) { maxOf(0.0, exposed[it]) })
        }
    }

    private fun film(x: Double) = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)

    /** The PBR Neutral tone mapper of Khronos. */
    private fun neutral(light: DoubleArray): DoubleArray {
        val least = light.min()
        val offset = if (least < 0.08) least - 6.25 * least * least else 0.04
        val color = DoubleArray(3) { light[it] - offset }
        val peak = color.max()
        if (peak < 0.76) return color
        val newPeak = 1 - 0.24 * 0.24 / (peak - 0.52)
        val gray = 1 - 1 / (0.15 * (peak - newPeak) + 1)
        return DoubleArray(3) { color[it] * newPeak / peak * (1 - gray) + newPeak * gray }
    }
}
