package dev.lazyz.scenes.images

import dev.lazyz.Rgba
import dev.lazyz.world.material.Texture

/**
 * Combines images and colours that files keep apart to one texture. The larger image determines the size; see [at] for
 * the other.
 */
internal object ChannelPacking {
    /**
     * Returns a texture with [roughness] as green and [metallic] as blue, and 255 for an image that is null.
     * [ofRoughness] and [ofMetallic] return the number, 0..255, of a texel: by default its grey.
     */
    fun metallicRoughness(
        roughness: Texture?,
        metallic: Texture?,
        ofRoughness: (Int) -> Int = ::grey,
        ofMetallic: (Int) -> Int = ::grey,
    ): Texture? {
        val larger = larger(roughness, metallic) ?: return null
        return packed(larger, Texture.Encoding.LINEAR) { x, y ->
            val green = roughness?.let { ofRoughness(at(it, x, y, larger)) } ?: 0xFF
            val blue = metallic?.let { ofMetallic(at(it, x, y, larger)) } ?: 0xFF
            0xFFFF0000.toInt() or (green shl 8) or blue
        }
    }

    /** Returns the colours of [color], or white if it is null, with [opacity] as alpha: its own alpha, or its grey. */
    fun withOpacity(color: Texture?, opacity: Texture): Texture {
        val larger = checkNotNull(larger(color, opacity))
        return packed(larger, Texture.Encoding.SRGB) { x, y ->
            val texel = at(opacity, x, y, larger)
            val alpha = if (opacity.hasAlpha) texel ushr 24 else grey(texel)
            val rgb = color?.let { at(it, x, y, larger) and 0xFFFFFF } ?: 0xFFFFFF
            alpha shl 24 or rgb
        }
    }

    /** Returns [texture] on a ground of [color], mixed in linear light. */
    fun onColor(texture: Texture, color: Rgba): Texture = packed(texture, Texture.Encoding.SRGB) { x, y ->
        val top = Rgba.ofArgb(texture.texel(x, y))
        val below = color.alpha * (1f - top.alpha)
        val alpha = top.alpha + below
        fun mixed(upper: Float, lower: Float) = if (alpha > 0f) (upper * top.alpha + lower * below) / alpha else 0f
        Rgba(mixed(top.red, color.red), mixed(top.green, color.green), mixed(top.blue, color.blue), alpha).toArgb()
    }

    /**
     * Returns [texture] in the middle of an image of [width] x [height], the rest of which is [color], so that texels
     * beyond its border have this colour. If the image is twice as large, so do those of the mip levels.
     */
    fun framed(texture: Texture, width: Int, height: Int, color: Rgba): Texture {
        val left = (width - texture.width) / 2
        val top = (height - texture.height) / 2
        val outside = color.toArgb()
        val texels = IntArray(Math.multiplyExact(width, height)) {
            val x = it % width - left
            val y = it / width - top
            if (x in 0 until texture.width && y in 0 until texture.height) texture.texel(x, y) else outside
        }
        return Texture(
            width, height, texels, texture.filter, texture.wrapU, texture.wrapV, texture.name, texture.mipFilter,
            texture.encoding,
        )
    }

    private fun larger(first: Texture?, second: Texture?): Texture? = when {
        first == null -> second
        second == null -> first
        second.width.toLong() * second.height > first.width.toLong() * first.height -> second
        else -> first
    }

    private inline fun packed(like: Texture, encoding: Texture.Encoding, texel: (Int, Int) -> Int): Texture {
        val texels = IntArray(like.width * like.height) { texel(it % like.width, it / like.width) }
        return Texture(
            like.width, like.height, texels, like.filter, like.wrapU, like.wrapV, like.name, like.mipFilter, encoding,
        )
    }

    /** Returns the texel of [texture] at the place of texel ([x], [y]) of [like]. */
    private fun at(texture: Texture, x: Int, y: Int, like: Texture): Int = texture.texel(
        (x.toLong() * texture.width / like.width).toInt(),
        (y.toLong() * texture.height / like.height).toInt(),
    )

    private fun grey(texel: Int): Int = ((texel ushr 16 and 0xFF) + (texel ushr 8 and 0xFF) + (texel and 0xFF) + 1) / 3
}
