package dev.lazyz.world.material

import dev.lazyz.Rgba
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.6: texture sampling. */
class TextureTest {
    /** The texels of a texture with [width] columns. The red code of texel (x, y) is 16 y + x. */
    private fun numbered(width: Int, height: Int): IntArray =
        IntArray(width * height) { (255 - it) shl 24 or ((16 * (it / width) + it % width) shl 16) }

    private fun read(texture: Texture, u: Float, v: Float): FloatArray = FloatArray(4).also { texture.sample(u, v, it) }

    @Test
    fun rule_6_6_noCoordinateIsTooStrange() {
        val strange = listOf(
            Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.MAX_VALUE, -Float.MAX_VALUE,
            -1e-30f, Float.MIN_VALUE, Math.nextDown(1f), 1e10f, -0f,
        )
        for (filter in Texture.Filter.entries) {
            for (wrap in Texture.Wrap.entries) {
                val texture = Texture(3, 3, numbered(3, 3), filter, wrap, wrap)
                for (u in strange) for (v in strange) assertTrue(read(texture, u, v).all { it in 0f..1f })
                if (filter == Texture.Filter.NEAREST) {
                    assertArrayEquals(read(texture, 0f, 0f), read(texture, Float.NaN, Float.POSITIVE_INFINITY))
                }
            }
        }
    }

    @Test
    fun rule_6_6_theGreatestCoordinateIsAtTheEnd() {
        val clamped = Texture(3, 3, numbered(3, 3), Texture.Filter.NEAREST, Texture.Wrap.CLAMP, Texture.Wrap.CLAMP)
        for (far in listOf(Float.MAX_VALUE, -Float.MAX_VALUE)) {
            assertArrayEquals(read(clamped, Math.signum(far), 0f), read(clamped, far, 0f))
        }
    }

    @Test
    fun opacityIsFound() {
        assertEquals(false, Texture(1, 2, intArrayOf(-1, 0xFF000000.toInt())).hasAlpha)
        assertEquals(true, Texture(1, 2, intArrayOf(-1, 0x7F000000)).hasAlpha)
    }

    @Test
    fun wrongSizesAreRefused() {
        fun message(width: Int, height: Int, texels: Int): String? =
            assertThrows(IllegalArgumentException::class.java) { Texture(width, height, IntArray(texels)) }.message
        assertEquals("texture must have at least one texel: 0 x 1", message(0, 1, 0))
        assertEquals("texture must have at least one texel: 1 x 0", message(1, 0, 0))
        assertEquals("texture of 2 x 3 needs 6 texels: 5", message(2, 3, 5))
        assertThrows(IllegalArgumentException::class.java) { Texture(65536, 65536, IntArray(0)) }
    }

    private fun assertMean(expected: Rgba, texture: Texture) {
        val mean = texture.meanColor
        assertEquals(expected.red, mean.red, 1e-6f) { "$texture" }
        assertEquals(expected.green, mean.green, 1e-6f) { "$texture" }
        assertEquals(expected.blue, mean.blue, 1e-6f) { "$texture" }
        assertEquals(expected.alpha, mean.alpha, 1e-6f) { "$texture" }
    }

    @Test
    fun theMeanColorIsThatOfTheOnlyVisibleTexel() {
        val texels = IntArray(256 * 256)
        texels[0] = 0xFFFF0000.toInt()
        assertMean(Rgba(1f, 0f, 0f, 1f / 65536), Texture(256, 256, texels))
    }

    @Test
    fun theMeanColorOfInvisibleTexelsIsThePlainMean() {
        assertMean(Rgba(0.5f, 0f, 1f, 0f), Texture(2, 1, intArrayOf(0x00FF00FF, 0x000000FF)))
    }
}
