package dev.lazyz.scenes.images

/**
 * Converts sRGB-encoded numbers, as files store colours, to linear light (IEC 61966-2-1).
 *
 * Uses [StrictMath.pow], so that a colour is bit for bit the same on every machine.
 */
internal object SrgbDecoding {
    private val ofByte = FloatArray(256) { decode(it / 255.0) }

    /** Decodes a number in 0..1. Numbers outside the range are clamped, and NaN gives 0. */
    fun decode(encoded: Double): Float = when {
        !(encoded > 0.0) -> 0f
        encoded >= 1.0 -> 1f
        encoded <= 0.04045 -> (encoded / 12.92).toFloat()
        else -> StrictMath.pow((encoded + 0.055) / 1.055, 2.4).toFloat()
    }

    /** Decodes an 8-bit code, 0..255, to the same value that the core module gives a texel with this code. */
    fun decodeByte(code: Int): Float = ofByte[code]
}
