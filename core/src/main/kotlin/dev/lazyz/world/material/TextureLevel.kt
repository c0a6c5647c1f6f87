package dev.lazyz.world.material

import dev.lazyz.Srgb
import kotlin.math.floor

/**
 * The texels of an image, or of a smaller copy of it.
 *
 * @property argb texels as in [Texture], in rows from the top
 */
internal class TextureLevel(val width: Int, val height: Int, val argb: IntArray, val encoding: TextureEncoding) {
    init {
        require(width > 0 && height > 0) { "texture must have at least one texel: $width x $height" }
        require(argb.size.toLong() == width.toLong() * height) {
            "texture of $width x $height needs ${width.toLong() * height} texels: ${argb.size}"
        }
    }

    /** The linear values of the codes of colours. */
    private val colors = if (encoding == TextureEncoding.SRGB) Srgb.linearOfCode else LINEAR

    /** Adds [weight] times the colour at ([u], [v]), sampled by the rules of [texture], to [out] at 0..3. */
    fun add(texture: Texture, u: Double, v: Double, weight: Float, out: FloatArray) {
        val x = position(u, width, texture.wrapU)
        val y = position(v, height, texture.wrapV)
        if (texture.filter == TextureFilter.NEAREST) {
            val row = wrapIndex(floor(y).toInt(), height, texture.wrapV) * width
            val texel = argb[row + wrapIndex(floor(x).toInt(), width, texture.wrapU)]
            for (channel in 0 until 4) out[channel] += weight * channelOf(texel, channel)
            return
        }

        // Weight the four texels whose centres surround the point
        val left = floor(x - 0.5)
        val top = floor(y - 0.5)
        val fx = (x - 0.5 - left).toFloat()
        val fy = (y - 0.5 - top).toFloat()
        val column = wrapIndex(left.toInt(), width, texture.wrapU)
        val nextColumn = wrapIndex(left.toInt() + 1, width, texture.wrapU)
        val row = wrapIndex(top.toInt(), height, texture.wrapV) * width
        val nextRow = wrapIndex(top.toInt() + 1, height, texture.wrapV) * width
        val t00 = argb[row + column]
        val t10 = argb[row + nextColumn]
        val t01 = argb[nextRow + column]
        val t11 = argb[nextRow + nextColumn]
        out[0] += weight * mixed(colors, t00 ushr 16, t10 ushr 16, t01 ushr 16, t11 ushr 16, fx, fy)
        out[1] += weight * mixed(colors, t00 ushr 8, t10 ushr 8, t01 ushr 8, t11 ushr 8, fx, fy)
        out[2] += weight * mixed(colors, t00, t10, t01, t11, fx, fy)
        out[3] += weight * mixed(LINEAR, t00 ushr 24, t10 ushr 24, t01 ushr 24, t11 ushr 24, fx, fy)
    }

    /** Returns the value between four texels in the channel whose codes are the lowest eight bits of each. */
    private fun mixed(values: FloatArray, t00: Int, t10: Int, t01: Int, t11: Int, fx: Float, fy: Float): Float {
        val upper = values[t00 and 0xFF] * (1f - fx) + values[t10 and 0xFF] * fx
        val lower = values[t01 and 0xFF] * (1f - fx) + values[t11 and 0xFF] * fx
        return upper * (1f - fy) + lower * fy
    }

    /**
     * Converts a coordinate to a position in texels: in 0 until [size] for REPEAT, 0..[size] for CLAMP, 0 until twice
     * the [size] for MIRROR.
     */
    private fun position(coordinate: Double, size: Int, wrap: TextureWrap): Double {
        if (!coordinate.isFinite()) return 0.0
        val wrapped = when (wrap) {
            TextureWrap.REPEAT -> coordinate - floor(coordinate)
            TextureWrap.CLAMP -> coordinate.coerceIn(0.0, 1.0)
            TextureWrap.MIRROR -> coordinate - 2.0 * floor(coordinate / 2.0)
        }
        return wrapped * size
    }

    /** Wraps an index that is at most one outside the range of [position] to an index of the level. */
    private fun wrapIndex(index: Int, size: Int, wrap: TextureWrap): Int = when {
        index in 0 until size -> index
        wrap == TextureWrap.REPEAT -> if (index < 0) size - 1 else 0
        wrap == TextureWrap.MIRROR -> if (index in size until 2 * size) 2 * size - 1 - index else 0
        else -> if (index < 0) 0 else size - 1
    }

    /** Returns red (0), green, blue or alpha (3) of [texel], linear, 0..1. */
    fun channelOf(texel: Int, channel: Int): Float = when (channel) {
        0 -> colors[texel ushr 16 and 0xFF]
        1 -> colors[texel ushr 8 and 0xFF]
        2 -> colors[texel and 0xFF]
        else -> LINEAR[texel ushr 24]
    }

    /** Returns the code of a linear value, 0..1. */
    fun encoded(value: Float): Int =
        if (encoding == TextureEncoding.SRGB) Srgb.encode(value) else (value * 255f + 0.5f).toInt()

    private companion object {
        /** The values of codes that are linear: alpha, and all of [TextureEncoding.LINEAR]. */
        val LINEAR = FloatArray(256) { it / 255f }
    }
}
