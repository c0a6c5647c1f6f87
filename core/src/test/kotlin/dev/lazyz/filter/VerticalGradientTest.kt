package dev.lazyz.filter

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
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

    @Test
    fun transparentPixelsShowTheGradient() {
        // Codes at 1/8, 3/8, 5/8 and 7/8 of the way
        val rows = List(4) { row(it, 4, 0).single() }
        val expected = listOf(0xFF2C342A, 0xFF645C1E, 0xFF9C8412, 0xFFD4AC06).map { it.toInt() }
        assertEquals(expected.map { Integer.toHexString(it) }, rows.map { Integer.toHexString(it) })
    }

    @Test
    fun opaquePixelsAreUnchanged() {
        val codes = IntArray(256) { 0xFF shl 24 or (it * 0x10101) }
        assertArrayEquals(codes, row(5, 9, *codes))
    }

    @Test
    fun translucentPixelsAreMixedInLinearLight() {
        val half = row(1, 3, 0x80FFFFFF.toInt()).single()
        val behind = Rgba.ofArgb(row(1, 3, 0).single())
        val expected = (128 + 127 * behind.red) / 255
        assertEquals(expected, Rgba.ofArgb(half).red, 0.004f)
        assertEquals(0xFF, half ushr 24)

        // The more opaque, the nearer to the colour in front
        val whites = List(256) { row(1, 3, it shl 24 or 0xFFFFFF).single() and 0xFF }
        assertEquals(whites.sorted(), whites)
        assertTrue(whites.toSet().size > 100)
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
