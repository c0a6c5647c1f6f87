package dev.lazyz.scenes.triangulation

import java.util.StringTokenizer

/**
 * The lines of a text within bytes, with their numbers; a line ends at a line feed, a carriage return, or both.
 *
 * Bytes are taken as ISO 8859-1, which any bytes are. Not thread safe.
 *
 * @param position where the first line begins
 * @param firstLine its number
 */
internal class TextLines(private val bytes: ByteArray, position: Int = 0, firstLine: Int = 1) {
    /** Where the next line begins. */
    var position = position
        private set

    /** Number of the line that was read last; lines count from 1. */
    var number = firstLine - 1
        private set

    /** Returns the next line without its end, or null after the last. */
    fun next(): String? {
        if (position >= bytes.size) return null
        var end = position
        while (end < bytes.size && bytes[end] != LINE_FEED && bytes[end] != CARRIAGE_RETURN) end++
        val line = String(bytes, position, end - position, Charsets.ISO_8859_1)
        val isPair = end + 1 < bytes.size && bytes[end] == CARRIAGE_RETURN && bytes[end + 1] == LINE_FEED
        position = minOf(end + (if (isPair) 2 else 1), bytes.size)
        number++
        return line
    }

    /** Returns the words of the next line that has any, or null after the last. */
    fun nextWords(): List<String>? {
        while (true) {
            val line = next() ?: return null
            val words = words(line)
            if (words.isNotEmpty()) return words
        }
    }

    companion object {
        private const val LINE_FEED = '\n'.code.toByte()
        private const val CARRIAGE_RETURN = '\r'.code.toByte()

        /** Splits at white space. */
        fun words(line: String): List<String> {
            val tokens = StringTokenizer(line)
            return List(tokens.countTokens()) { tokens.nextToken() }
        }
    }
}
