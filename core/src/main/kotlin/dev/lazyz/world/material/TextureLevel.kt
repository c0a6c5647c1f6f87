package dev.lazyz.world.material

import dev.lazyz.Srgb
import kotlin.math.floor

/**
 * The texels of an image, or of a smaller copy of it.
 *
 * @property argb texels as in [Texture], in rows from the top
 */
internal class TextureLevel(val width: Int, val height: Int, val argb: IntArray, val encoding: TextureEncoding,) {
    init {
        require(width > 0 && height > 0) { "texture must have at least one texel: $width x $height" }
        require(argb.size.toLong() == width.toLong() * height) {
            "texture of $width x $height needs ${width.toLong() * height} texels: ${argb.size}"
        }
    }

    /** Adds [weight] times the colour at ([u], [v]), sampled by the rules of [texture], to [out] at 0..3. */
    fun add(texture: Texture, u: Double, v: Double, weight: Float, out: FloatArray) {
        val x = position(u, width, texture.wrapU)
        val y = position(v, height, texture.wrapV)
        if (texture.filter == TextureFilter.NEAREST) {
            val texel = argb[index(texture, floor(x).toInt(), floor(y).toInt())]
            for (channel in 0 until 4) out[channel] += weight * channelOf(texel, channel)
            return
        }

        // Weight the four texels whose centres surround the point
        val left = floor(x - 0.5)
        val top = floor(y - 0.5)
        val fx = (x - 0.5 - left).toFloat()
        val fy = (y - 0.5 - top).toFloat()
        val t00 = argb[index(texture, left.toInt(), top.toInt())]
        val t10 = argb[index(texture, left.toInt() + 1, top.toInt())]
        val t01 = argb[index(texture, left.toInt(), top.toInt() + 1)]
        val t11 = argb[index(texture, left.toInt() + 1, top.toInt() + 1)]
        for (channel in 0 until 4) {
            val upper = channelOf(t00, channel) * (1f - fx) + channelOf(t10, channel) * fx
            val lower = channelOf(t01, channel) * (1f - fx) + channelOf(t11, channel) * fx
            out[channel] += weight * (upper * (1f - fy) + lower * fy)
        }
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

    private fun index(texture: Texture, x: Int, y: Int): Int =
        wrapIndex(y, height, texture.wrapV) * width + wrapIndex(x, width, texture.wrapU)

    /** Wraps an index that is at most one outside the range of [position] to an index of the level. */
    private fun wrapIndex(index: Int, size: Int, wrap: TextureWrap): Int = when {
        index in 0 until size -> index
        wrap == TextureWrap.REPEAT -> if (index < 0) size - 1 else 0
        wrap == TextureWrap.MIRROR -> if (index in size until 2 * size) 2 * size - 1 - index else 0
        else -> if (index < 0) 0 else size - 1
    }

    /** Returns red (0), green, blue or alpha (3) of [texel], linear, 0..1. */
    fun channelOf(texel: Int, channel: Int): Float = when (channel) {
        0 -> decoded(texel ushr 16 and 0xFF)
        1 -> decoded(texel ushr 8 and 0xFF)
        2 -> decoded(texel and 0xFF)
        else -> (texel ushr 24) / 255f
    }

    private fun decoded(code: Int): Float = if (encoding == TextureEncoding.SRGB) Srgb.decode(code) else code / 255f

    /** Returns the code of a linear value, 0..1. */
    fun encoded(value: Float): Int =
        if (encoding == TextureEncoding.SRGB) Srgb.encode(value) else (value * 255f + 0.5f).toInt()
}
