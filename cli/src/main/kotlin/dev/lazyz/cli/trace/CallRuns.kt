package dev.lazyz.cli.trace

import java.io.ByteArrayOutputStream
import java.util.Base64
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/**
 * The shading calls of a [ShadingOrder] as text that a script can read.
 *
 * Most calls are at the pixel to the right of the call before, so the calls are written as *runs* of such neighbours of
 * which all are discarded, or none is. A run is two numbers: how far its first pixel is from the one after the run
 * before, at first from pixel 0, with the sign as the lowest bit; and its length, with the lowest bit set if it is
 * discarded. A number is written in groups of 7 bits from the lowest, with the highest bit of the byte set if another
 * follows. The bytes are compressed in zlib format (RFC 1950) and written in base 64.
 */
internal object CallRuns {
    /** Returns the calls of [order]. */
    fun text(order: ShadingOrder): String = Base64.getEncoder().encodeToString(compressed(bytes(order)))

    private fun bytes(order: ShadingOrder): ByteArray {
        val bytes = ByteArrayOutputStream()
        var expected = 0
        var call = 0
        while (call < order.size) {
            val first = order.place(call)
            val isDiscarded = order.isDiscarded(call)
            var length = 1
            while (
                call + length < order.size && order.place(call + length) == first + length &&
                order.isDiscarded(call + length) == isDiscarded
            ) {
                length++
            }
            bytes.writeNumber(signed(first - expected))
            bytes.writeNumber(2L * length + (if (isDiscarded) 1 else 0))
            expected = first + length
            call += length
        }
        return bytes.toByteArray()
    }

    private fun signed(number: Int): Long = if (number < 0) -2L * number - 1 else 2L * number

    private fun ByteArrayOutputStream.writeNumber(number: Long) {
        var rest = number
        while (rest >= 0x80) {
            write((rest and 0x7F).toInt() or 0x80)
            rest = rest shr 7
        }
        write(rest.toInt())
    }

    private fun compressed(bytes: ByteArray): ByteArray {
        val result = ByteArrayOutputStream()
        val deflater = Deflater(Deflater.BEST_COMPRESSION)
        try {
            DeflaterOutputStream(result, deflater).use { it.write(bytes) }
        } finally {
            deflater.end()
        }
        return result.toByteArray()
    }
}
