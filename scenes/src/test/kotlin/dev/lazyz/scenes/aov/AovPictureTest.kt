package dev.lazyz.scenes.aov

import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Pictures of AOVs have the same bits on every machine, and their legends say what the colours mean. */
class AovPictureTest {
    private val grey = 0xFFD8D8D8.toInt()
    private val region = Region(5, 7, 9, 8)
    private val infinity = Float.POSITIVE_INFINITY

    private fun image(aov: Aov, vararg numbers: Float) = AovImage(aov, region, numbers, 0.0, 100.0)

    private fun image(aov: Aov, vararg numbers: Int) = AovImage(aov, region, numbers)

    private fun pixels(image: AovImage): List<Int> {
        val picture = AovPicture.of(image)
        assertEquals(200, picture.width)
        assertTrue(picture.height in 20..65) { "${picture.height}" }
        assertTrue(picture.argb.all { it ushr 24 == 0xFF })
        return (0 until 4).map { picture.argb(it, 0) }
    }

    @Test
    fun scalarsAreOnTheScaleFromTheLeastToTheGreatest() {
        val depths = pixels(image(Aov.DEPTH, 2f, infinity, 3f, 4f))
        assertEquals(
            listOf(Rgba.viridis(0.0).toArgb(), grey, Rgba.viridis(0.5).toArgb(), Rgba.viridis(1.0).toArgb()),
            depths,
        )
        val counts = pixels(image(Aov.OVERDRAW, 0, 1, 2, 4))
        assertEquals(
            listOf(grey, Rgba.viridis(0.25).toArgb(), Rgba.viridis(0.5).toArgb(), Rgba.viridis(1.0).toArgb()),
            counts,
        )
        val coverage = pixels(image(Aov.COVERAGE, 0f, 0.25f, 0.5f, 0.5f))
        assertEquals(
            listOf(grey, Rgba.viridis(0.25).toArgb(), Rgba.viridis(0.5).toArgb(), Rgba.viridis(0.5).toArgb()),
            coverage,
        )
    }

    /** With 4 x 4 samples, 16 fragments are one surface. */
    @Test
    fun theLegendOfOverdrawCountsSurfacesNotSamples() {
        val once = AovImage(Aov.OVERDRAW, region, intArrayOf(0, 1, 2, 5))
        val often = AovImage(Aov.OVERDRAW, region, intArrayOf(0, 16, 32, 80), samplesPerPixel = 16)
        assertEquals(AovPicture.of(once).pixelHash(), AovPicture.of(often).pixelHash())
        assertThrows(IllegalArgumentException::class.java) { AovImage(Aov.OVERDRAW, region, IntArray(4), 0) }
    }

    @Test
    fun picturesHaveTheSameBitsEverywhere() {
        val gradient = AovImage(Aov.DEPTH, Region(0, 0, 320, 8), FloatArray(2560) { it / 100f }, 0.0, 30.0)
        assertEquals(HASH, AovPicture.of(gradient).pixelHash())
    }

    @Test
    fun emptyAndExtremePicturesHaveALegend() {
        for (aov in Aov.entries) {
            val size = aov.channels.size
            val image = if (aov.isInteger) {
                AovImage(aov, Region(0, 0, 1, 1), intArrayOf(aov.background.toInt()))
            } else {
                AovImage(aov, Region(0, 0, 1, 1), FloatArray(size) { aov.background.toFloat() }, 0.0, 1.0)
            }
            assertEquals(grey, AovPicture.of(image).argb(0, 0)) { aov.id }
        }
        val wild = image(Aov.DEPTH, -1e30f, 1e30f, Float.NaN, 0f)
        assertEquals(grey, pixels(wild)[2])
        assertTrue(AovPicture.of(image(Aov.OVERDRAW, Int.MAX_VALUE, 0, 0, 0)).height > 20)
    }

    private companion object {
        const val HASH = "52015e9dc6221d63cd395c03da9069f156b307dc1b61a6d329d10928603dbaad"
    }
}
