package dev.lazyz.world.material

import dev.lazyz.Rgba
import dev.lazyz.spi.Srgb
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Mip-maps, an image and its smaller copies: each level has half the width and height of the one before, rounded down,
 * to one texel. A texel of a level is the mean of the area of the level before that it covers, in linear light,
 * weighted by alpha, so that transparent texels give no colour. Thread safe; the levels are computed on first use.
 *
 * @property image level 0
 */
internal class MipLevels(val image: TextureLevel) {
    /** Number of the smallest level, of one texel. */
    val last: Int = Int.SIZE_BITS - 1 - maxOf(image.width, image.height).countLeadingZeroBits()

    /** Whether any texel of the image is not fully opaque. */
    val hasAlpha: Boolean by lazy { image.argb.any { it ushr 24 != 0xFF } }

    /** The mean of all texels of the image, from their sums: levels with few texels round alpha too much. */
    val mean: Rgba by lazy {
        val sums = DoubleArray(CHANNELS)
        for (row in 0 until image.height) addRow(image, row, 1.0, 1, sums)
        val alpha = (sums[ALPHA] / (255.0 * sums[AREA])).toFloat()
        Rgba(mean(sums, 0, 0), mean(sums, 0, 1), mean(sums, 0, 2), alpha)
    }

    private val smaller: List<TextureLevel> by lazy {
        generateSequence(image) { if (it.width * it.height == 1) null else half(it) }.drop(1).toList()
    }

    /** Returns level [number], 0..[last]. */
    operator fun get(number: Int): TextureLevel = if (number == 0) image else smaller[number - 1]

    private fun half(from: TextureLevel): TextureLevel {
        val width = maxOf(from.width / 2, 1)
        val height = maxOf(from.height / 2, 1)
        val argb = IntArray(width * height)
        val sums = DoubleArray(CHANNELS * width)
        for (y in 0 until height) {
            // Add up the rows that the new row covers, each with the part that is covered
            sums.fill(0.0)
            val top = y.toDouble() * from.height / height
            val bottom = (y + 1.0) * from.height / height
            for (row in top.toInt() until minOf(ceil(bottom).toInt(), from.height)) {
                addRow(from, row, minOf(row + 1.0, bottom) - maxOf(row.toDouble(), top), width, sums)
            }
            for (x in 0 until width) argb[y * width + x] = texel(from, sums, CHANNELS * x)
        }
        return TextureLevel(width, height, argb, from.encoding)
    }

    /** Adds row [row], times [part], to the sums of the [width] new texels. */
    private fun addRow(from: TextureLevel, row: Int, part: Double, width: Int, sums: DoubleArray) {
        for (x in 0 until width) {
            val left = x.toDouble() * from.width / width
            val right = (x + 1.0) * from.width / width
            for (column in left.toInt() until minOf(ceil(right).toInt(), from.width)) {
                val area = part * (minOf(column + 1.0, right) - maxOf(column.toDouble(), left))
                val texel = from.argb[row * from.width + column]
                val alpha = area * (texel ushr 24)
                val at = CHANNELS * x
                for (channel in 0 until 3) {
                    val value = from.channelOf(texel, channel)
                    sums[at + channel] += alpha * value
                    sums[at + PLAIN + channel] += area * value
                }
                sums[at + ALPHA] += alpha
                sums[at + AREA] += area
            }
        }
    }

    /** Returns the mean of the sums from [at] on, as a texel. */
    private fun texel(from: TextureLevel, sums: DoubleArray, at: Int): Int {
        val opacity = (sums[at + ALPHA] / sums[at + AREA] + 0.5).toInt()
        return opacity shl 24 or (from.encoded(mean(sums, at, 0)) shl 16) or
            (from.encoded(mean(sums, at, 1)) shl 8) or from.encoded(mean(sums, at, 2))
    }

    /** Returns the mean of a colour channel, linear, of the sums from [at] on. Without alpha, it is the plain mean. */
    private fun mean(sums: DoubleArray, at: Int, channel: Int): Float {
        val alpha = sums[at + ALPHA]
        val mean = if (alpha > 0.0) sums[at + channel] / alpha else sums[at + PLAIN + channel] / sums[at + AREA]
        return minOf(mean, 1.0).toFloat()
    }

    companion object {
        /** Sums of a texel: red, green, blue times alpha; alpha; red, green, blue; area. */
        private const val CHANNELS = 8
        private const val ALPHA = 3
        private const val PLAIN = 4
        private const val AREA = 7

        /**
         * Returns the level whose texels have the size of a footprint of [square] square texels of the image: the
         * logarithm of its side to base 2, linear between powers of two of [square] (at most 0.05 too low).
         */
        fun levelOf(square: Double): Float {
            val bits = square.toRawBits()
            val exponent = (bits ushr MANTISSA_BITS).toInt() - EXPONENT_BIAS
            val mantissa = (bits and (1L shl MANTISSA_BITS) - 1).toDouble() / (1L shl MANTISSA_BITS)
            return ((exponent + mantissa) / 2).toFloat()
        }

        private const val MANTISSA_BITS = 52
        private const val EXPONENT_BIAS = 1023
    }
}

/**
 * The texels of an image, or of a smaller copy of it.
 *
 * @property argb texels as in [Texture], in rows from the top
 */
internal class TextureLevel(val width: Int, val height: Int, val argb: IntArray, val encoding: Texture.Encoding) {
    init {
        require(width > 0 && height > 0) { "texture must have at least one texel: $width x $height" }
        require(argb.size.toLong() == width.toLong() * height) {
            "texture of $width x $height needs ${width.toLong() * height} texels: ${argb.size}"
        }
    }

    /** The linear values of the codes of colours. */
    private val colors = if (encoding == Texture.Encoding.SRGB) Srgb.linearOfCode else LINEAR

    /** Adds [weight] times the colour at ([u], [v]), sampled by the rules of [texture], to [out] at 0..3. */
    fun add(texture: Texture, u: Double, v: Double, weight: Float, out: FloatArray) {
        val x = position(u, width, texture.wrapU)
        val y = position(v, height, texture.wrapV)
        if (texture.filter == Texture.Filter.NEAREST) {
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
    private fun position(coordinate: Double, size: Int, wrap: Texture.Wrap): Double {
        if (!coordinate.isFinite()) return 0.0
        val wrapped = when (wrap) {
            Texture.Wrap.REPEAT -> coordinate - floor(coordinate)
            Texture.Wrap.CLAMP -> coordinate.coerceIn(0.0, 1.0)
            Texture.Wrap.MIRROR -> coordinate - 2.0 * floor(coordinate / 2.0)
        }
        return wrapped * size
    }

    /** Wraps an index that is at most one outside the range of [position] to an index of the level. */
    private fun wrapIndex(index: Int, size: Int, wrap: Texture.Wrap): Int = when {
        index in 0 until size -> index
        wrap == Texture.Wrap.REPEAT -> if (index < 0) size - 1 else 0
        wrap == Texture.Wrap.MIRROR -> if (index in size until 2 * size) 2 * size - 1 - index else 0
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
        if (encoding == Texture.Encoding.SRGB) Srgb.encode(value) else (value * 255f + 0.5f).toInt()

    private companion object {
        /** The values of codes that are linear: alpha, and all of [Texture.Encoding.LINEAR]. */
        val LINEAR = FloatArray(256) { it / 255f }
    }
}
