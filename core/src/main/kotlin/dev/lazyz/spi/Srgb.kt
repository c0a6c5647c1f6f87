package dev.lazyz.spi

/**
 * The sRGB transfer function between linear light and 8-bit codes (IEC 61966-2-1), equal bit for bit on every machine.
 *
 * Encoding rounds to the nearest code. It uses the 255 linear values at which the code changes, computed once with
 * [StrictMath], so that no call depends on a library's `pow` (contract rule 6.3).
 */
internal object Srgb {
    /** The linear values of the 256 codes; not to be changed. */
    val linearOfCode: FloatArray = FloatArray(256) { decode(it / 255.0).toFloat() }

    /** `threshold[k]` is the smallest linear value whose code is at least k. */
    private val threshold = FloatArray(257) {
        when (it) {
            0 -> Float.NEGATIVE_INFINITY
            256 -> Float.POSITIVE_INFINITY
            else -> leastFloatFrom(decode((it - 0.5) / 255.0))
        }
    }

    /**
     * A table that converts the bits of a value in [LEAST]..1 to its code. The index is `bits - LEAST_BITS` shifted
     * right by [BUCKET_SHIFT], which gives 256 buckets an octave. The code is `summand + bits`, shifted right by
     * [BUCKET_SHIFT]. The code changes at most once in a bucket; from that value on, the lower bits of the sum carry.
     */
    val summands: IntArray = IntArray(BUCKETS + 1)

    init {
        var code = 0
        for (bucket in 0..BUCKETS) {
            val least = leastOfBucket(bucket)
            while (least >= threshold[code + 1]) code++
            val next = minOf(threshold[code + 1].toRawBits() - least.toRawBits(), BUCKET)
            summands[bucket] = (code shl BUCKET_SHIFT) + BUCKET - next - least.toRawBits()
        }
    }

    /** Returns the linear value of an 8-bit [code]. */
    fun decode(code: Int): Float = linearOfCode[code]

    /** Returns the 8-bit code of [linear]; values outside 0..1 are clamped and NaN gives 0. */
    fun encode(linear: Float): Int {
        if (!(linear >= LEAST)) return 0
        if (linear >= 1f) return 255
        val bits = linear.toRawBits()
        return summands[bits - LEAST_BITS ushr BUCKET_SHIFT] + bits ushr BUCKET_SHIFT
    }

    /** Packs a linear colour with straight alpha to `0xAARRGGBB`. */
    fun pack(red: Float, green: Float, blue: Float, alpha: Float): Int =
        encodeAlpha(alpha) shl 24 or (encode(red) shl 16) or (encode(green) shl 8) or encode(blue)

    private fun encodeAlpha(alpha: Float): Int = when {
        !(alpha > 0f) -> 0
        alpha >= 1f -> 255
        else -> (alpha.toDouble() * 255.0 + 0.5).toInt()
    }

    private fun leastFloatFrom(value: Double): Float {
        val nearest = value.toFloat()
        return if (nearest < value) Math.nextUp(nearest) else nearest
    }

    /** Returns the linear value of [encoded], 0..1. The definition of this function for the whole project. */
    fun decode(encoded: Double): Double =
        if (encoded <= 0.04045) encoded / 12.92 else StrictMath.pow((encoded + 0.055) / 1.055, 2.4)

    private fun leastOfBucket(bucket: Int): Float = Float.fromBits(LEAST_BITS + (bucket shl BUCKET_SHIFT))

    /** 2^-13. Smaller values have code 0. */
    const val LEAST: Float = 1f / 8192f

    /** The bits of [LEAST]: an exponent of 127 - 13. */
    const val LEAST_BITS: Int = (127 - 13) shl 23

    /** The bits of 1. */
    const val MOST_BITS: Int = 127 shl 23
    const val BUCKET_SHIFT: Int = 23 - 8
    private const val BUCKET = 1 shl BUCKET_SHIFT

    /** Number of buckets below 1. The value 1 has its own bucket. */
    private const val BUCKETS = 13 shl 8
}
