package dev.lazyz

import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RgbaTest {
    @Test
    fun textBecomesColour() {
        assertEquals(0xFF336699.toInt(), Rgba.parse("#336699").toArgb())
        assertEquals(0xFF336699.toInt(), Rgba.parse("#369").toArgb())
        assertEquals(0x80ABCDEF.toInt(), Rgba.parse("#AbCdEf80").toArgb())
        assertEquals(Rgba.TRANSPARENT, Rgba.parse("transparent"))
        assertEquals(Rgba.BLACK, Rgba.parse("black"))
        assertEquals(Rgba.WHITE, Rgba.parse("white"))
        assertEquals(Rgba.WHITE, Rgba.parse("#fff"))
    }

    @Test
    fun namesOfCssAreColoursInAnyCase() {
        assertEquals(0xFF87CEEB.toInt(), Rgba.parse("skyblue").toArgb())
        assertEquals(0xFF663399.toInt(), Rgba.parse("RebeccaPurple").toArgb())
        assertEquals(Rgba.ofRgb(0xFF0000), Rgba.parse("red"))
        assertEquals(Rgba.parse("darkslategray"), Rgba.parse("darkslategrey"))
        assertEquals(Rgba.TRANSPARENT, Rgba.parse("TRANSPARENT"))
    }

    @Test
    fun otherTextIsNamedInTheMessage() {
        val wrong =
            listOf("", "#", "#12", "#1234", "#12345", "#1234567", "#123456789", "mud", "#ggg", "fff", " #fff", "#fff\n")
        for (text in wrong) {
            val message = assertThrows(IllegalArgumentException::class.java) { Rgba.parse(text) }.message
            assertTrue(message!!.endsWith(text)) { message }
        }
    }

    @Test
    fun coloursAreValues() {
        assertEquals(Rgba(0.1f, 0.2f, 0.3f, 0.4f), Rgba(0.1f, 0.2f, 0.3f).withAlpha(0.4f))
        assertEquals(Rgba(0.2f, 0.4f, 0.6f, 0.5f), Rgba(0.1f, 0.2f, 0.3f, 0.5f).scaled(2f))
        assertEquals(Rgba.WHITE.hashCode(), Rgba(1f, 1f, 1f).hashCode())
        assertTrue(Rgba.WHITE != Rgba.BLACK && !Rgba.WHITE.equals("white"))
    }

    @Test
    fun equalValuesHaveEqualHashes() {
        val numbers = listOf(0f, -0f, Float.NaN, -Float.NaN, 1f, Float.POSITIVE_INFINITY)
        val map = TextureMap(Texture(1, 1, intArrayOf(0)))
        val kinds = listOf<(Float) -> Any>(
            { Rgba(it, 0f, 0f) }, { Rgba(0f, it, 0f) }, { Rgba(0f, 0f, it) }, { Rgba(0f, 0f, 0f, it) },
            { NormalMap(map, it) }, { Falloff.inverseSquare(it.toDouble()) }, { MetallicRoughness(it, 0.5f) },
            { MetallicRoughness(0.5f, it) }, { OcclusionMap(map, it) }, { Environment.studio(it) },
            { ToneMapping(ToneMapping.Curve.NONE, it.toDouble()) },
        )
        for (make in kinds) {
            // Some kinds refuse some numbers
            val made = numbers.mapNotNull { runCatching { make(it) to make(it) }.getOrNull() }
            assertTrue(made.size >= 2, "$made")
            for ((a, b) in made) {
                assertEquals(a, b)
                for ((c, _) in made) if (a == c) assertEquals(a.hashCode(), c.hashCode(), "$a and $c")
            }
        }
    }

    /** Smith's inverse: value is the greatest component, saturation the range divided by it, hue where in its sixth. */
    @Test
    fun everyCodeHasItsHueSaturationAndValue() {
        for (rgb in 0..0xFFFFFF step 997) {
            val red = (rgb ushr 16) / 255.0
            val green = (rgb ushr 8 and 0xFF) / 255.0
            val blue = (rgb and 0xFF) / 255.0
            val value = maxOf(red, green, blue)
            val range = value - minOf(red, green, blue)
            val sixth = when {
                range == 0.0 -> 0.0
                value == red -> (green - blue) / range
                value == green -> 2.0 + (blue - red) / range
                else -> 4.0 + (red - green) / range
            }
            val saturation = if (value == 0.0) 0.0 else range / value
            val color = Rgba.hsv((60.0 * sixth).toFloat(), saturation.toFloat(), value.toFloat())
            assertEquals(Rgba.ofRgb(rgb).toArgb(), color.toArgb()) { "#" + rgb.toString(16) }
        }
    }

    @Test
    fun hsvOutsideItsRangeIsNamedInTheMessage() {
        fun assertNamed(name: String, action: () -> Unit) {
            val message = assertThrows(IllegalArgumentException::class.java, action).message
            assertTrue(message!!.startsWith(name)) { message }
        }
        for (wrong in listOf(-0.001f, 1.001f, Float.NaN)) {
            assertNamed("saturation") { Rgba.hsv(0f, wrong, 1f) }
            assertNamed("value") { Rgba.hsv(0f, 1f, wrong) }
            assertNamed("alpha") { Rgba.hsv(0f, 1f, 1f, wrong) }
        }
        for (wrong in listOf(Float.NaN, Float.POSITIVE_INFINITY)) assertNamed("hueDegrees") { Rgba.hsv(wrong, 1f, 1f) }
    }

    @Test
    fun linearLightIsThatOfTheTable() {
        for (code in 0..255) assertEquals(Rgba.ofRgb(code).blue, Rgba.linearOf(code / 255.0))
        for (below in listOf(-0.0, -1.0, Double.NEGATIVE_INFINITY, Double.NaN)) assertEquals(0f, Rgba.linearOf(below))
        for (above in listOf(1.0, 1.5, Double.POSITIVE_INFINITY)) assertEquals(1f, Rgba.linearOf(above))
        assertEquals((0.04 / 12.92).toFloat(), Rgba.linearOf(0.04))
    }
}
