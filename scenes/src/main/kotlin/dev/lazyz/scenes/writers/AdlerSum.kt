package dev.lazyz.scenes.writers

import java.nio.ByteBuffer

/**
 * The Adler-32 checksum of a stream, combined from the checksums of its parts.
 *
 * The checksum is two numbers modulo 65,521: 1 plus all bytes, and the sum of the first number's values after each
 * byte.
 *
 * Source: RFC 1950, section 9.
 */
internal class AdlerSum {
    private var bytes = 1L
    private var sums = 0L

    /** Appends a part of [length] bytes with the checksum [adler]. */
    fun add(adler: Int, length: Int) {
        val ofPart = adler and 0xFFFF

        // The part's first sums start at 1, but here they start at the value before the part
        sums = (sums + (adler ushr 16) + length % MODULUS * (bytes + MODULUS - 1)) % MODULUS
        bytes = (bytes + ofPart + MODULUS - 1) % MODULUS
    }

    /** Returns the checksum as it is stored at the end of a zlib stream. */
    fun toBytes(): ByteArray = ByteBuffer.allocate(Int.SIZE_BYTES).putInt((sums shl 16 or bytes).toInt()).array()

    private companion object {
        const val MODULUS = 65_521L
    }
}
