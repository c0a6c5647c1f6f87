package dev.lazyz

/**
 * The sRGB transfer function between linear light and 8-bit codes (IEC 61966-2-1), the same bits on every machine.
 *
 * Encoding rounds to the nearest code. It is a table of the 255 linear values at which the code changes, computed once
 * with [StrictMath], so that no call depends on a library's `pow` (contract rule 6.3).
 */
internal object Srgb {
    private val linearOfCode = FloatArray(256) { toLinear(it / 255.0).toFloat() }

    /** `threshold[k]` is the least linear value whose code is at least k. */
    private val threshold = FloatArray(257) {
        when (it) {
            0 -> Float.NEGATIVE_INFINITY
            256 -> Float.POSITIVE_INFINITY
            else -> leastFloatFrom(toLinear((it - 0.5) / 255.0))
        }
    }

    /** The code of the least value of each of [BUCKETS] equal parts of 0..1: a first guess at most a few codes low. */
    private val codeOfBucket = ByteArray(BUCKETS + 1) { searchCode(it / BUCKETS.toFloat()).toByte() }

    fun decode(code: Int): Float = linearOfCode[code]

    /** Returns the 8-bit code of [linear]; values outside 0..1 are clamped and NaN gives 0. */
    fun encode(linear: Float): Int {
        if (!(linear > 0f)) return 0
        if (linear >= 1f) return 255
        var code = codeOfBucket[(linear * BUCKETS).toInt()].toInt() and 0xFF
        while (linear >= threshold[code + 1]) code++
        return code
    }

    /** Packs a linear colour with straight alpha to `0xAARRGGBB`. */
    fun pack(red: Float, green: Float, blue: Float, alpha: Float): Int =
        encodeAlpha(alpha) shl 24 or (encode(red) shl 16) or (encode(green) shl 8) or encode(blue)

    private fun encodeAlpha(alpha: Float): Int = when {
        !(alpha > 0f) -> 0
        alpha >= 1f -> 255
        else -> (alpha.toDouble() * 255.0 + 0.5).toInt()
    }

    private fun searchCode(linear: Float): Int {
        var code = 0
        while (code < 255 && linear >= threshold[code + 1]) code++
        return code
    }

    private fun leastFloatFrom(value: Double): Float {
        val nearest = value.toFloat()
        return if (nearest < value) Math.nextUp(nearest) else nearest
    }

    private fun toLinear(encoded: Double): Double =
        if (encoded <= 0.04045) encoded / 12.92 else StrictMath.pow((encoded + 0.055) / 1.055, 2.4)

    private const val BUCKETS = 4096
}
