package dev.lazyz.filter

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.spi.Srgb
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class VerticalGradientTest {
    private val top = Rgba.ofRgb(0x102030)
    private val bottom = Rgba.ofRgb(0xF0C000)

    /** Returns row [y] of [height] rows, of which [argb] is what the renderer gives. */
    private fun row(y: Int, height: Int, vararg argb: Int): IntArray {
        var result = IntArray(0)
        val sink = RowSink { _, row, _, _ -> result = row }
        val region = Region(3, 0, 3 + argb.size, height)
        val gradient = VerticalGradient(top, bottom).behind(region, height, sink)
        gradient.row(y, argb, IntArray(argb.size), IntArray(argb.size))
        return result
    }

    /** The formula of the contract, for all alphas and codes, in rows of pictures of any height. */
    @Test
    fun rule_6_15_pixelsAreThoseOfTheFormula() {
        val random = Random(615)
        for (height in listOf(1, 2, 7, 480, 100_003)) {
            val y = random.nextInt(height)
            for (alpha in 0..254) {
                val front = IntArray(32) { alpha shl 24 or (random.nextInt() and 0xFFFFFF) }
                val actual = row(y, height, *front.copyOf())
                for ((i, color) in front.withIndex()) {
                    fun light(shift: Int): Float {
                        val (a, b) = listOf(top, bottom).map { it.toArgb() ushr shift and 0xFF }
                        val behind = Srgb.decode((a + (b - a) * ((y + 0.5) / height)) / 255.0)
                        val own = Srgb.decode((color ushr shift and 0xFF) / 255.0).toFloat()
                        return ((alpha * own.toDouble() + (255 - alpha) * behind) / 255.0).toFloat()
                    }
                    assertEquals(Rgba(light(16), light(8), light(0)).toArgb(), actual[i]) {
                        "$y of $height, %08x".format(color)
                    }
                }
            }
        }
    }

    @Test
    fun elementsBeyondTheRowAreNotTouched() {
        val argb = IntArray(5)
        val sink = VerticalGradient(top, bottom).behind(Region(0, 2, 3, 4), 6) { _, _, _, _ -> }
        sink.row(2, argb, IntArray(5), IntArray(5))
        assertEquals(listOf(false, false, false, true, true), argb.map { it == 0 })
    }

    @Test
    fun wrongValuesAreRefused() {
        assertThrows(IllegalArgumentException::class.java) { VerticalGradient(top, Rgba.TRANSPARENT) }
        assertThrows(IllegalArgumentException::class.java) { VerticalGradient(top.withAlpha(0.5f), bottom) }
        assertThrows(IllegalArgumentException::class.java) {
            VerticalGradient(top, bottom).behind(Raster(2, 5).region, 4) { _, _, _, _ -> }
        }
    }
}
