package dev.lazyz.filter

import dev.lazyz.Srgb

/**
 * Means of colours in linear light. Light is added as integers of [LIGHT_BITS] bits, times the 8-bit alpha and a
 * weight: sums are exact, and their order does not matter.
 */
internal object LightSums {
    /** Red, green, blue and alpha. */
    const val CHANNELS: Int = 4
    const val ALPHA: Int = 3
    const val LIGHT_BITS: Int = 24

    /** The light of each sRGB code, 0..2^[LIGHT_BITS]; not to be changed. */
    val LIGHT: IntArray = IntArray(256) { (Srgb.decode(it / 255.0) * (1 shl LIGHT_BITS) + 0.5).toInt() }

    /** Passes the light and the alpha of a sample with the colour [color], `0xAARRGGBB`, times [weight] to [use]. */
    inline fun of(color: Int, weight: Long, use: (red: Long, green: Long, blue: Long, alpha: Long) -> Unit) {
        val alpha = weight * (color ushr 24)
        val red = alpha * LIGHT[color shr 16 and 0xFF]
        val green = alpha * LIGHT[color shr 8 and 0xFF]
        use(red, green, alpha * LIGHT[color and 0xFF], alpha)
    }

    /** Adds [count] samples of [color], `0xAARRGGBB`, to the sums from [at] on. */
    fun add(sums: LongArray, at: Int, color: Int, count: Long) {
        of(color, count) { red, green, blue, alpha ->
            sums[at] += red
            sums[at + 1] += green
            sums[at + 2] += blue
            sums[at + ALPHA] += alpha
        }
    }

    /**
     * Returns the mean, `0xAARRGGBB`, of the sums from [at] on: red, green, blue and alpha. Where there is no alpha, it
     * has the colour of [corner].
     *
     * @param weight the sum of the weights
     * @param bits of light; fewer if the sums of the colours were divided by a power of two
     */
    fun mean(sums: LongArray, at: Int, weight: Long, corner: Int, bits: Int = LIGHT_BITS): Int {
        val alpha = sums[at + ALPHA]
        if (alpha <= 0L) return corner and 0xFFFFFF
        val opacity = minOf((2 * alpha + weight) / (2 * weight), 255L).toInt()
        val light = alpha.toDouble() * (1 shl bits)
        return opacity shl 24 or (code(sums[at], light) shl 16) or (code(sums[at + 1], light) shl 8) or
            code(sums[at + 2], light)
    }

    /** Returns the sRGB code of the light whose sum is [sum], where white has the sum [white]. */
    private fun code(sum: Long, white: Double): Int = Srgb.encode((sum.toDouble() / white).toFloat())
}
