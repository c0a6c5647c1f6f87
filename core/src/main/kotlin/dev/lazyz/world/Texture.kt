package dev.lazyz.world

import dev.lazyz.Srgb

/** How a [Texture] is sampled between texels. */
public enum class TextureFilter {
    /** The texel that contains the point. */
    NEAREST,

    /** The four texels around the point, weighted by distance in linear light. */
    BILINEAR,
}

/** How a [Texture] is sampled outside 0..1. */
public enum class TextureWrap {
    /** The image is repeated. */
    REPEAT,

    /** The nearest texel at the border is used. */
    CLAMP,

    /** The image is repeated, and every other copy is mirrored. */
    MIRROR,
}

/** What the red, green and blue codes of a [Texture] mean. Alpha is always linear. */
public enum class TextureEncoding {
    /** Colours, encoded by the sRGB curve. */
    SRGB,

    /** Numbers in 0..1, code / 255, such as components of normals or roughness. */
    LINEAR,
}

/**
 * An image that colours a surface.
 *
 * Texture coordinates: u increases to the right and v downward; (0, 0) is the upper left corner of the upper left texel
 * and (1, 1) the lower right corner of the lower right one. This is the convention of glTF; a v of OBJ becomes `1 - v`.
 * Texels are 8-bit codes with straight alpha, `0xAARRGGBB`, in rows from the top; colours are sRGB unless [encoding] says
 * otherwise. Filtering uses decoded values, for colours linear light. There are
 * no mipmaps, because the contract requires one lookup for each sample (rule 6.6).
 *
 * The texels are not copied: immutable and thread safe if the caller does not change the array.
 *
 * @property width number of columns, at least 1
 * @property height number of rows, at least 1
 * @param argb the texels, width x height
 * @property filter sampling between texels
 * @property wrapU sampling outside 0..1 in the direction of u
 * @property wrapV sampling outside 0..1 in the direction of v
 * @property name name for messages and files
 * @property encoding what the codes of red, green and blue mean
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
    public val encoding: TextureEncoding = TextureEncoding.SRGB,
) {
    init {
        require(width > 0 && height > 0) { "texture must have at least one texel: $width x $height" }
        require(argb.size.toLong() == width.toLong() * height) {
            "texture of $width x $height needs ${width.toLong() * height} texels: ${argb.size}"
        }
    }

    /** Whether any texel is not fully opaque. Cost: one pass over the texels, once. */
    public val hasAlpha: Boolean by lazy { argb.any { it ushr 24 != 0xFF } }

    /** Returns the texel at column [x], 0 until [width], and row [y], 0 until [height], as `0xAARRGGBB`. */
    public fun texel(x: Int, y: Int): Int = argb[y * width + x]

    /** Returns this texture with other sampling rules; the texels are shared. */
    public fun withSampling(filter: TextureFilter, wrapU: TextureWrap, wrapV: TextureWrap): Texture =
        Texture(width, height, argb, filter, wrapU, wrapV, name, encoding)

    /** Returns this texture with another [name]; the texels are shared. */
    public fun withName(name: String): Texture = Texture(width, height, argb, filter, wrapU, wrapV, name, encoding)

    /** Returns this texture with another [encoding]; the texels are shared. */
    public fun withEncoding(encoding: TextureEncoding): Texture =
        if (encoding == this.encoding) this else Texture(width, height, argb, filter, wrapU, wrapV, name, encoding)

    /** The value of each code of red, green and blue. */
    private val valueOfCode = if (encoding == TextureEncoding.SRGB) Srgb.linearOfCode else LINEAR

    /**
     * Samples the texture at ([u], [v]) and stores red, green, blue (linear light) and alpha, each in 0..1, in [out] at
     * 0..3.
     *
     * A coordinate that is NaN or infinite is treated as texel position 0. Cost: one texel with
     * [TextureFilter.NEAREST], four with [TextureFilter.BILINEAR]; no allocation.
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
     * Converts a coordinate to a position in texels: in 0 until [size] for REPEAT, 0..[size] for CLAMP, 0 until twice
     * the [size] for MIRROR.
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

    /** Wraps an index that is at most one outside the range of [position] to an index of the texture. */
    private fun wrapIndex(index: Int, size: Int, wrap: TextureWrap): Int = when {
        index in 0 until size -> index
        wrap == TextureWrap.REPEAT -> if (index < 0) size - 1 else 0
        wrap == TextureWrap.MIRROR -> if (index in size until 2 * size) 2 * size - 1 - index else 0
        else -> if (index < 0) 0 else size - 1
    }

    private fun channelOf(texel: Int, channel: Int): Float = when (channel) {
        0 -> valueOfCode[texel ushr 16 and 0xFF]
        1 -> valueOfCode[texel ushr 8 and 0xFF]
        2 -> valueOfCode[texel and 0xFF]
        else -> (texel ushr 24) / 255f
    }

    private companion object {
        val LINEAR = FloatArray(256) { it / 255f }
    }

    override fun toString(): String = "Texture($width x $height, $filter, $wrapU, $wrapV, \"$name\")"
}
