package dev.lazyz.scenes.writers

import java.nio.ByteBuffer

/**
 * The Adler-32 check sum of a stream, put together from those of its parts.
 *
 * The sum is two numbers modulo 65,521: 1 plus all bytes, and the sum of what the first one is after each byte.
 *
 * Source: RFC 1950, section 9.
 */
internal class AdlerSum {
    private var bytes = 1L
    private var sums = 0L

    /** Appends a part of [length] bytes whose own check sum is [adler]. */
    fun add(adler: Int, length: Int) {
        val ofPart = adler and 0xFFFF

        // Each of the part's sums begins with what came before it in place of 1
        sums = (sums + (adler ushr 16) + length % MODULUS * (bytes + MODULUS - 1)) % MODULUS
        bytes = (bytes + ofPart + MODULUS - 1) % MODULUS
    }

    /** The check sum as it stands at the end of a zlib stream. */
    fun toBytes(): ByteArray = ByteBuffer.allocate(Int.SIZE_BYTES).putInt((sums shl 16 or bytes).toInt()).array()

    private companion object {
        const val MODULUS = 65_521L
    }
}
