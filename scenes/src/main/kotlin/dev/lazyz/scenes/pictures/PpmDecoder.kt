package dev.lazyz.scenes.pictures

import dev.lazyz.scenes.SceneFormatException

/**
 * Reads binary PPM files (`P6`) with 8 bits a channel, such as [dev.lazyz.scenes.writers.PpmSink] writes.
 *
 * Source: the Netpbm project, "PPM Format Specification".
 */
internal class PpmDecoder private constructor(private val bytes: ByteArray, private val name: String) {
    private var next = MAGIC.length

    private fun picture(): Picture {
        val width = number("width", MOST_SIDE)
        val height = number("height", MOST_SIDE)
        val most = number("maximum", UShort.MAX_VALUE.toInt())
        if (most != BYTE_MAX) {
            fail("its maximum is $most, and only $BYTE_MAX can be read", "save it with 8 bits a channel")
        }

        // One white space character is between the header and the pixels
        next++
        val missing = 3L * width * height - (bytes.size - next)
        if (missing > 0) fail("it ends $missing bytes before its last pixel", "check that it was written completely")
        val start = next
        return Picture.ofArgb(width, height, IntArray(width * height) { OPAQUE or rgb(start + 3 * it) })
    }

    private fun rgb(at: Int): Int =
        bytes[at].toInt() and 0xFF shl 16 or (bytes[at + 1].toInt() and 0xFF shl 8) or (bytes[at + 2].toInt() and 0xFF)

    private fun number(what: String, most: Int): Int {
        skipSpace()
        var value = 0L
        val first = next
        while (next < bytes.size && bytes[next] in DIGITS && value <= most) value = 10 * value + (bytes[next++] - ZERO)
        if (next == first || value !in 1..most) fail("its $what is not in 1..$most", "check that it is a PPM file")
        return value.toInt()
    }

    /** Skips white space and comments, from `#` to the end of the line. */
    private fun skipSpace() {
        while (next < bytes.size) {
            val char = bytes[next].toInt().toChar()
            if (char == '#') {
                while (next < bytes.size && bytes[next] != LINE_END) next++
            } else if (!char.isWhitespace()) {
                return
            }
            next++
        }
    }

    private fun fail(problem: String, remedy: String): Nothing = throw SceneFormatException(name, null, problem, remedy)

    companion object {
        private const val MAGIC = "P6"
        private const val BYTE_MAX = 255
        private const val MOST_SIDE = 1 shl 24
        private const val OPAQUE = 0xFF shl 24
        private const val ZERO = '0'.code.toByte()
        private const val LINE_END = '\n'.code.toByte()
        private val DIGITS = ZERO..'9'.code.toByte()

        /**
         * Returns the picture of [bytes], or null if they do not begin like a PPM file.
         *
         * @throws SceneFormatException if the file is damaged, or has more than 8 bits a channel
         */
        fun decode(bytes: ByteArray, name: String): Picture? {
            val isPpm = bytes.size > MAGIC.length && MAGIC.indices.all { bytes[it] == MAGIC[it].code.toByte() }
            return if (isPpm) PpmDecoder(bytes, name).picture() else null
        }
    }
}
