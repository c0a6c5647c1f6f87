package dev.lazyz.scenes.images

import java.io.ByteArrayOutputStream

/**
 * Removes the colour profile from a JPEG file, because the JDK's decoder applies the profile in floating point, and
 * this cannot be disabled (ITU-T T.81, annex B, for the segments; ICC.1:2022, annex B.4, for the profile in them).
 */
internal object JpegProfile {
    private const val MARK = 0xFF
    private const val START_OF_IMAGE = 0xD8
    private const val START_OF_SCAN = 0xDA
    private const val APPLICATION_2 = 0xE2
    private val name = "ICC_PROFILE\u0000".toByteArray(Charsets.ISO_8859_1)

    /** Returns [bytes] without profile segments, or [bytes] itself if there are none or it is not a JPEG. */
    fun remove(bytes: ByteArray): ByteArray {
        if (bytes.size < 2 || at(bytes, 0) != MARK || at(bytes, 1) != START_OF_IMAGE) return bytes
        val kept = ByteArrayOutputStream(bytes.size)
        var from = 0
        var position = 2

        // Go through the segments before the image data: a marker, a kind, and a length that includes its own two
        // bytes
        while (position + 4 <= bytes.size && at(bytes, position) == MARK && at(bytes, position + 1) != START_OF_SCAN) {
            val end = position + 2 + (at(bytes, position + 2) shl 8 or at(bytes, position + 3))
            if (at(bytes, position + 1) == APPLICATION_2 && isNamed(bytes, position + 4)) {
                kept.write(bytes, from, position - from)
                from = minOf(end, bytes.size)
            }
            position = end
        }
        if (from == 0) return bytes
        kept.write(bytes, from, bytes.size - from)
        return kept.toByteArray()
    }

    private fun at(bytes: ByteArray, index: Int) = bytes[index].toInt() and 0xFF

    private fun isNamed(bytes: ByteArray, start: Int): Boolean =
        start + name.size <= bytes.size && name.indices.all { bytes[start + it] == name[it] }
}
