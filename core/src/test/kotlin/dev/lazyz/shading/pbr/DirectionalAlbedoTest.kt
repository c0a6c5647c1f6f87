package dev.lazyz.shading.pbr

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 6.10: the table of the split sum is the integral of the formulas of rule 6.8. */
class DirectionalAlbedoTest {
    /** The integral over all directions of light, with weights 1 - (1 - V.H)^5 and (1 - V.H)^5. */
    private fun integral(cosine: Double, roughness: Double): Pair<Double, Double> {
        val alpha = roughness * roughness
        val sine = Math.sqrt(1.0 - cosine * cosine)
        var scale = 0.0
        var bias = 0.0
        val rows = 600
        val columns = 600
        for (row in 0 until rows) {
            val z = (row + 0.5) / rows
            val level = Math.sqrt(1.0 - z * z)
            for (column in 0 until columns) {
                val angle = Math.PI * (column + 0.5) / columns
                val x = level * Math.cos(angle)
                val y = level * Math.sin(angle)
                val length = Math.sqrt((x + sine) * (x + sine) + y * y + (z + cosine) * (z + cosine))
                val cosineH = (z + cosine) / length
                val vh = (sine * (x + sine) + cosine * (z + cosine)) / length
                val weight = Appendix.distribution(cosineH, alpha) * Appendix.visibility(z, cosine, alpha) * z
                val grazing = Math.pow(1.0 - vh, 5.0)
                scale += weight * (1.0 - grazing)
                bias += weight * grazing
            }
        }
        val solidAngle = 2.0 * Math.PI / (rows * columns.toDouble())
        return scale * solidAngle to bias * solidAngle
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_10_theTableIsTheIntegral() {
        for (cosine in listOf(0.12, 0.21, 0.5, 0.83, 1.0)) {
            for (roughness in listOf(0.35, 0.5, 0.77, 1.0)) {
                val (scale, bias) = integral(cosine, roughness)
                DirectionalAlbedo.at(cosine.toFloat(), roughness.toFloat()) { actualScale, actualBias ->
                    assertEquals(scale, actualScale.toDouble(), 0.012, "scale at $cosine, $roughness")
                    assertEquals(bias, actualBias.toDouble(), 0.012, "bias at $cosine, $roughness")
                }
            }
        }
    }

    @Test
    fun rule_6_10_aMirrorReflectsAsFresnelSays() {
        for (cosine in listOf(0.25f, 0.5f, 1f)) {
            DirectionalAlbedo.at(cosine, 0f) { scale, bias ->
                assertEquals(1f, scale + bias, 0.01f)
                assertEquals(Microfacets.grazing(cosine), bias, 0.01f)
            }
        }
    }

    @Test
    fun neverMoreThanAllLight() {
        for (i in 0..200) {
            for (k in 0..50) {
                DirectionalAlbedo.at(i / 200f, k / 50f) { scale, bias ->
                    assertTrue(scale >= 0f && bias >= 0f && scale + bias <= 1.001f) { "$i $k: $scale + $bias" }
                }
            }
        }
    }
}
