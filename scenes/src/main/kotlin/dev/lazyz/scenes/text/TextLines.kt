package dev.lazyz.scenes.text

import java.util.StringTokenizer

/**
 * The lines of a text within bytes, with their numbers, and the words of a line; a line ends at a line feed, a carriage
 * return, or both, and a word at white space.
 *
 * Bytes are taken as ISO 8859-1, which any bytes are. Not thread safe.
 *
 * @param position where the first line begins
 * @param firstLine its number
 */
internal class TextLines(val bytes: ByteArray, position: Int = 0, firstLine: Int = 1) {
    /** Where the next line begins. */
    var position = position
        private set

    /** Number of the line that was read last; lines count from 1. */
    var number = firstLine - 1
        private set

    private var lineStart = position
    private var lineEnd = position

    /** Where the word that was read last begins. */
    var wordStart = position
        private set

    /** Where the word that was read last ends. */
    var wordEnd = position
        private set

    /** Whether the line that was read last is cut off by the end of the text: it has no line end. */
    val isCutOff: Boolean get() = lineEnd == bytes.size

    /** Returns the next line without its end, or null after the last. */
    fun next(): String? =
        if (nextLine()) String(bytes, lineStart, lineEnd - lineStart, Charsets.ISO_8859_1) else null

    /** Moves to the next line, before its first word; false after the last. */
    fun nextLine(): Boolean {
        if (position >= bytes.size) return false
        var end = position
        while (end < bytes.size && bytes[end] != LINE_FEED && bytes[end] != CARRIAGE_RETURN) end++
        lineStart = position
        lineEnd = end
        wordEnd = position
        val isPair = end + 1 < bytes.size && bytes[end] == CARRIAGE_RETURN && bytes[end + 1] == LINE_FEED
        position = minOf(end + (if (isPair) 2 else 1), bytes.size)
        number++
        return true
    }

    /** Moves to the next word of the line; false after the last. */
    fun nextWord(): Boolean {
        var start = wordEnd
        while (start < lineEnd && isSpace(bytes[start])) start++
        var end = start
        while (end < lineEnd && !isSpace(bytes[end])) end++
        wordStart = start
        wordEnd = end
        return start < end
    }

    /** Moves to the next word of the text, on this line or a later one; false after the last. */
    fun nextWordOfText(): Boolean {
        while (!nextWord()) {
            if (!nextLine()) return false
        }
        return true
    }

    /** Whether no word follows on the line. */
    fun isBlank(): Boolean {
        for (i in wordEnd until lineEnd) if (!isSpace(bytes[i])) return false
        return true
    }

    /** Returns how many words follow on the line. Cost: linear in their length. */
    fun countWords(): Int {
        var count = 0
        for (i in wordEnd until lineEnd) {
            if (!isSpace(bytes[i]) && (i == wordEnd || isSpace(bytes[i - 1]))) count++
        }
        return count
    }

    /** Whether the word that was read last is [word], which is in lower case and ASCII, in any case. */
    fun isWord(word: String): Boolean {
        if (wordEnd - wordStart != word.length) return false
        for (i in word.indices) {
            val byte = bytes[wordStart + i].toInt()
            val isUpper = byte >= 'A'.code && byte <= 'Z'.code
            if ((if (isUpper) byte + ('a' - 'A') else byte) != word[i].code) return false
        }
        return true
    }

    /** Returns the word that was read last. */
    fun word(): String = String(bytes, wordStart, wordEnd - wordStart, Charsets.ISO_8859_1)

    /** Returns the words that follow on the line, one space between them, and moves to its end. */
    fun restOfLine(): String {
        val rest = words(String(bytes, wordEnd, lineEnd - wordEnd, Charsets.ISO_8859_1)).joinToString(" ")
        wordEnd = lineEnd
        return rest
    }

    /** Moves to the end of the line. */
    fun endLine() {
        wordEnd = lineEnd
    }

    companion object {
        private const val SPACE = ' '.code.toByte()
        private const val TAB = '\t'.code.toByte()
        private const val FORM_FEED = '\u000C'.code.toByte()
        private const val LINE_FEED = '\n'.code.toByte()
        private const val CARRIAGE_RETURN = '\r'.code.toByte()

        /** Whether [byte] is white space within a line. */
        fun isSpace(byte: Byte): Boolean = byte == SPACE || byte == TAB || byte == FORM_FEED

        /** Splits at white space. */
        fun words(line: String): List<String> {
            val tokens = StringTokenizer(line)
            return List(tokens.countTokens()) { tokens.nextToken() }
        }
    }
}
