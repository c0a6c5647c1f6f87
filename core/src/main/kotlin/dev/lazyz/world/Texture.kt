package dev.lazyz.world

import dev.lazyz.Srgb

/** How a [Texture] is read between its texels. */
public enum class TextureFilter {
    /** The texel that contains the point. */
    NEAREST,

    /** The four texels around the point, weighted by distance, in linear light. */
    BILINEAR,
}

/** What a [Texture] shows outside 0..1. */
public enum class TextureWrap {
    /** The picture again and again. */
    REPEAT,

    /** The texel at the border. */
    CLAMP,

    /** The picture again and again, every other time mirrored. */
    MIRROR,
}

/**
 * A picture that a surface wears.
 *
 * Texture coordinates: u grows to the right and v downward, (0, 0) is the upper left corner of the upper left texel and
 * (1, 1) the lower right corner of the lower right one (glTF's convention; OBJ's v is `1 - v` here). Texels are 8-bit
 * sRGB with straight alpha, `0xAARRGGBB`, in rows from the top. Sampling happens in linear light. There are no mipmaps:
 * one sample a pixel is the contract.
 *
 * Immutable as long as the caller leaves [argb] alone; thread safe.
 *
 * @throws IllegalArgumentException if a side is not positive or [argb] does not hold width x height texels
 */
public class Texture @JvmOverloads constructor(
    public val width: Int,
    public val height: Int,
    private val argb: IntArray,
    public val filter: TextureFilter = TextureFilter.BILINEAR,
    public val wrapU: TextureWrap = TextureWrap.REPEAT,
    public val wrapV: TextureWrap = TextureWrap.REPEAT,
    public val name: String = "",
) {
    init {
        require(width > 0 && height > 0) { "texture must have at least one texel: $width x $height" }
        require(argb.size.toLong() == width.toLong() * height) {
            "texture of $width x $height needs ${width.toLong() * height} texels: ${argb.size}"
        }
    }

    /** Whether some texel is not fully opaque. Cost: one pass over the texels, once. */
    public val hasAlpha: Boolean by lazy { argb.any { it ushr 24 != 0xFF } }

    /** Returns the texel at column [x] and row [y] as `0xAARRGGBB`. */
    public fun texel(x: Int, y: Int): Int = argb[y * width + x]

    /** Returns this texture with other sampling rules; the texels are shared. */
    public fun withSampling(filter: TextureFilter, wrapU: TextureWrap, wrapV: TextureWrap): Texture =
        Texture(width, height, argb, filter, wrapU, wrapV, name)

    /**
     * Reads the texture at ([u], [v]) into [out]: red, green, blue in linear light and alpha, in 0..1.
     *
     * A coordinate that is NaN or infinite reads as 0. Cost: one or four texels, no allocation.
     */
    public fun sample(u: Float, v: Float, out: FloatArray) {
        val x = position(u, width, wrapU)
        val y = position(v, height, wrapV)
        if (filter == TextureFilter.NEAREST) {
            val texel = argb[index(StrictMath.floor(x).toInt(), StrictMath.floor(y).toInt())]
            for (channel in 0 until 4) out[channel] = channelOf(texel, channel)
            return
        }

        // Weight the four texels whose centres surround the point
        val left = StrictMath.floor(x - 0.5)
        val top = StrictMath.floor(y - 0.5)
        val fx = (x - 0.5 - left).toFloat()
        val fy = (y - 0.5 - top).toFloat()
        val t00 = argb[index(left.toInt(), top.toInt())]
        val t10 = argb[index(left.toInt() + 1, top.toInt())]
        val t01 = argb[index(left.toInt(), top.toInt() + 1)]
        val t11 = argb[index(left.toInt() + 1, top.toInt() + 1)]
        for (channel in 0 until 4) {
            val upper = channelOf(t00, channel) * (1f - fx) + channelOf(t10, channel) * fx
            val lower = channelOf(t01, channel) * (1f - fx) + channelOf(t11, channel) * fx
            out[channel] = upper * (1f - fy) + lower * fy
        }
    }

    /**
     * Maps a coordinate to texels: 0 until [size] when it repeats, 0..[size] when it is clamped, 0 until twice the [size]
     * when it is mirrored.
     */
    private fun position(coordinate: Float, size: Int, wrap: TextureWrap): Double {
        if (!coordinate.isFinite()) return 0.0
        val value = coordinate.toDouble()
        val wrapped = when (wrap) {
            TextureWrap.REPEAT -> value - StrictMath.floor(value)
            TextureWrap.CLAMP -> value.coerceIn(0.0, 1.0)
            TextureWrap.MIRROR -> value - 2.0 * StrictMath.floor(value / 2.0)
        }
        return wrapped * size
    }

    private fun index(x: Int, y: Int): Int = wrapIndex(y, height, wrapV) * width + wrapIndex(x, width, wrapU)

    /** Brings an index that is at most one outside of what [position] gives into the texture. */
    private fun wrapIndex(index: Int, size: Int, wrap: TextureWrap): Int = when {
        index in 0 until size -> index
        wrap == TextureWrap.REPEAT -> if (index < 0) size - 1 else 0
        wrap == TextureWrap.MIRROR -> if (index in size until 2 * size) 2 * size - 1 - index else 0
        else -> if (index < 0) 0 else size - 1
    }

    private fun channelOf(texel: Int, channel: Int): Float = when (channel) {
        0 -> Srgb.decode(texel ushr 16 and 0xFF)
        1 -> Srgb.decode(texel ushr 8 and 0xFF)
        2 -> Srgb.decode(texel and 0xFF)
        else -> (texel ushr 24) / 255f
    }

    override fun toString(): String = "Texture($width x $height, $filter, $wrapU, $wrapV, \"$name\")"
}
