package dev.lazyz.world.material

import dev.lazyz.Rgba
import kotlin.math.ceil

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
