package dev.lazyz.scenes.images

import dev.lazyz.Rgba

/** Converts 8-bit sRGB codes, as files store colours, to linear light. */
internal object SrgbDecoding {
    private val ofByte = FloatArray(256) { Rgba.linearOf(it / 255.0) }

    /** Decodes an 8-bit code, 0..255, to the same value that the core module gives a texel with this code. */
    fun decodeByte(code: Int): Float = ofByte[code]
}
