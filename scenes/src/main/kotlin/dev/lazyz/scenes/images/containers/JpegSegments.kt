package dev.lazyz.scenes.images.containers

/**
 * The segments of a JPEG file (ITU-T T.81, annex B): a marker, which is a byte of ones and a code, and for most codes a
 * length that includes its own two bytes. Compressed data follows the start of each scan.
 */
internal object JpegSegments {
    val SIGNATURE: ByteArray = byteArrayOf(0xFF.toByte(), 0xD8.toByte())

    private const val MARK = 0xFF
    private const val TEMPORARY = 0x01
    private const val EXTENSION = 0xC8
    private const val START_OF_SCAN = 0xDA
    private const val END_OF_IMAGE = 0xD9

    /** Frames and tables, restarts, scans, quantization, lines and restart intervals. */
    private val NEEDED = (0xC0..0xCF) - EXTENSION + (0xD0..0xD7) + (0xDA..0xDD)

    /** The application segments that say how colours are stored: their codes and names. */
    private val COLORS = mapOf(0xE0 to "JFIF\u0000", 0xEE to "Adobe").mapValues { (_, name) ->
        name.toByteArray(Charsets.ISO_8859_1)
    }

    /** Each scan can change the whole image; files of programs have some ten. */
    private const val MOST_SCANS = 100

    /** Returns the first image of the file without other segments, or null if it has too many scans. */
    fun needed(bytes: ByteArray): ByteArray? {
        val parts = Parts(bytes)
        val colors = HashSet<Int>()
        var scans = 0
        var at = SIGNATURE.size
        parts.keep(0, at)
        while (true) {
            at = marker(bytes, at)
            if (at < 0) break
            val code = bytes.code(at + 1)
            if (code == END_OF_IMAGE) {
                parts.keep(at, at + 2)
                break
            }
            val isAlone = code in 0xD0..0xD7 || code == TEMPORARY
            val end = at + 2 + if (isAlone) 0 else maxOf(bytes.code(at + 2) shl 8 or bytes.code(at + 3), 2)
            val isColor = COLORS[code]?.isAt(bytes, at + 4) == true && colors.add(code)
            if (code in NEEDED || isColor) parts.keep(at, end)
            at = minOf(end, bytes.size)
            if (code == START_OF_SCAN) {
                if (++scans > MOST_SCANS) return null
                val next = dataEnd(bytes, at)
                parts.keep(at, next)
                at = next
            }
        }
        return parts.toByteArray()
    }

    /** Returns where the next marker begins at [from] or after it, or -1 if there is none. */
    private fun marker(bytes: ByteArray, from: Int): Int {
        for (at in from until bytes.size - 1) {
            if (bytes.code(at) == MARK && bytes.code(at + 1) != MARK && bytes.code(at + 1) != 0) return at
        }
        return -1
    }

    /** Returns where the compressed data at [from] ends: at a marker other than a restart. */
    private fun dataEnd(bytes: ByteArray, from: Int): Int {
        var at = from
        while (true) {
            at = marker(bytes, at)
            if (at < 0) return bytes.size
            if (bytes.code(at + 1) !in 0xD0..0xD7) return at
            at += 2
        }
    }
}
