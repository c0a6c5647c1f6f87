package dev.lazyz

import dev.lazyz.spi.Fragment
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Contract rule 6.4: conversion from linear light to 8 bits and back. */
class SrgbTest {
    private fun red(linear: Float): Int = Rgba(linear, 0f, 0f).toArgb() shr 16 and 0xFF

    private fun alpha(alpha: Float): Int = Rgba(0f, 0f, 0f, alpha).toArgb() ushr 24

    @Test
    fun rule_6_4_alphaIsLinear() {
        val random = Random(2)
        for (code in 0..254) {
            var alpha = ((code + 0.5) / 255).toFloat()
            repeat(3) { alpha = Math.nextDown(alpha) }
            repeat(7) {
                assertEquals(Math.floor(alpha.toDouble() * 255 + 0.5).toInt(), alpha(alpha)) { "alpha $alpha" }
                alpha = Math.nextUp(alpha)
            }
        }
        repeat(10_000) {
            val alpha = random.nextFloat()
            assertEquals(Math.floor(alpha.toDouble() * 255 + 0.5).toInt(), alpha(alpha))
        }
    }

    @Test
    fun rule_6_4_theRestIsClamped() {
        for (low in listOf(-1f, -0f, 0f, Float.NaN, Float.NEGATIVE_INFINITY, Float.MIN_VALUE)) {
            assertEquals(0, red(low))
            assertEquals(0, alpha(low))
        }
        for (high in listOf(1f, 1.0001f, 7f, Float.MAX_VALUE, Float.POSITIVE_INFINITY, Math.nextDown(1f))) {
            assertEquals(255, red(high))
            assertEquals(255, alpha(high))
        }
    }

    @Test
    fun rule_6_4_componentsHaveTheirPlaces() {
        assertEquals(0xFF000000.toInt(), Rgba.BLACK.toArgb())
        assertEquals(-1, Rgba.WHITE.toArgb())
        assertEquals(0, Rgba.TRANSPARENT.toArgb())
        assertEquals(0x80FF7F00.toInt(), Rgba.ofArgb(0x80FF7F00.toInt()).toArgb())
        val fragment = Fragment()
        fragment.setColor(1f, 0f, 0f, 0f)
        assertEquals(0x00FF0000, fragment.toArgb())
    }
}
