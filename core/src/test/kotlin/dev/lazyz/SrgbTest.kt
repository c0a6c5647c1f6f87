package dev.lazyz

import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Contract rule 6.4: conversion from linear light to 8 bits and back. */
class SrgbTest {
    /** The sRGB curve in double precision, times 255, before rounding. */
    private fun codes(linear: Float): Double {
        val l = linear.toDouble()
        return 255 * if (l <= 0.0031308) 12.92 * l else 1.055 * StrictMath.pow(l, 1 / 2.4) - 0.055
    }

    private fun red(linear: Float): Int = Rgba(linear, 0f, 0f).toArgb() shr 16 and 0xFF

    private fun alpha(alpha: Float): Int = Rgba(0f, 0f, 0f, alpha).toArgb() ushr 24

    private fun assertNearest(linear: Float) {
        val exact = codes(linear.coerceIn(0f, 1f))
        // The published curve has a step of 3e-8 where its two parts meet, far from all values at which codes change
        assertEquals(Math.floor(exact + 0.5).toInt(), red(linear)) { "$linear is code $exact" }
    }

    @Test
    fun rule_6_4_everyCodeSurvives() {
        for (code in 0..255) {
            val argb = code shl 24 or (code shl 16) or (255 - code shl 8) or code
            assertEquals(argb, Rgba.ofArgb(argb).toArgb()) { "code $code" }
        }
    }

    @Test
    fun rule_6_4_decodingIsTheCurve() {
        for (code in 0..255) {
            val s = code / 255.0
            val exact = if (s <= 0.04045) s / 12.92 else StrictMath.pow((s + 0.055) / 1.055, 2.4)
            assertEquals(exact.toFloat(), Rgba.ofRgb(code shl 8).green)
        }
    }

    @Test
    fun rule_6_4_encodingRoundsToNearest() {
        val random = Random(1)
        repeat(20_000) { assertNearest(random.nextFloat()) }
        repeat(20_000) { assertNearest(random.nextFloat() * 0.01f) }
    }

    @Test
    fun rule_6_4_encodingRoundsToNearestBesideEveryStep() {
        for (code in 1..255) {
            val s = (code - 0.5) / 255
            val step = if (s <= 0.04045) s / 12.92 else StrictMath.pow((s + 0.055) / 1.055, 2.4)
            var linear = Math.nextDown(Math.nextDown(step.toFloat()))
            repeat(5) {
                // Here the code is certain, in spite of the rounding of the inverse curve
                assertEquals(if (linear >= step) code else code - 1, red(linear)) { "$linear beside $step" }
                linear = Math.nextUp(linear)
            }
        }
    }

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
