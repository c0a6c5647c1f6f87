package dev.lazyz.scenes.text

import java.io.IOException
import java.io.InputStream
import java.util.StringTokenizer

/**
 * Splits the text in a byte array into numbered lines, and lines into words. A line ends at a line feed, a carriage
 * return, or both. Words are separated by white space.
 *
 * Bytes are decoded as ISO 8859-1, which accepts any bytes. Not thread safe.
 *
 * @param bytes the text, or its beginning
 * @param position index of the first line's first byte
 * @param firstLine number of the first line
 * @param rest the rest of the text, or null if [bytes] is all of it. Then [bytes] holds a part of the text, at least
 *   the current line, and changes with the line
 * @param dropped number of bytes of the text that stand before [bytes]
 */
internal class TextLines(
    bytes: ByteArray,
    position: Int = 0,
    firstLine: Int = 1,
    rest: InputStream? = null,
    dropped: Long = 0,
) {
    private val window = ByteWindow(bytes, position, rest, dropped)

    /** The text around the current line. The indices below refer to it. */
    val bytes: ByteArray get() = window.bytes

    /** Index where the next line begins. */
    val position: Int get() = window.position

    /** The position in the text where the next line begins. */
    val offset: Long get() = window.offset

    /** Number of the line that was read last; lines are numbered from 1. */
    var number = firstLine - 1
        private set

    private var lineStart = position
    private var lineEnd = position

    /** Index where the word that was read last begins. */
    var wordStart = position
        private set

    /** Index where the word that was read last ends (exclusive). */
    var wordEnd = position
        private set

    /** Whether the line that was read last has no line terminator, because the text ends there. */
    val isCutOff: Boolean get() = lineEnd == window.size

    /** Returns the next line without its terminator, or null after the last line. */
    fun next(): String? =
        if (nextLine()) String(bytes, lineStart, lineEnd - lineStart, Charsets.ISO_8859_1) else null

    /**
     * Moves to the next line, before its first word; returns false after the last line.
     *
     * @throws IOException if the rest of the text cannot be read, or has a line of more than 256 MiB
     */
    fun nextLine(): Boolean {
        var end = window.position
        while (true) {
            val bytes = window.bytes
            val size = window.size
            while (end < size && bytes[end] != LINE_FEED && bytes[end] != CARRIAGE_RETURN) end++

            // A carriage return at the end can be half of a line's end
            val isComplete = end < size && (bytes[end] == LINE_FEED || end + 1 < size)
            if (isComplete || window.isAtEnd) break
            end -= window.position
            readMore()
        }
        val bytes = window.bytes
        val size = window.size
        val start = window.position
        if (start >= size) return false
        lineStart = start
        lineEnd = end
        wordEnd = start
        val isPair = end + 1 < size && bytes[end] == CARRIAGE_RETURN && bytes[end + 1] == LINE_FEED
        window.position = minOf(end + (if (isPair) 2 else 1), size)
        number++
        return true
    }

    private fun readMore() {
        if (window.size - window.position > ByteWindow.LONGEST) {
            throw IOException("line ${number + 1} is longer than ${ByteWindow.LONGEST} bytes")
        }
        window.more()
    }

    /** Moves to the next word of the line; returns false after the last word. */
    fun nextWord(): Boolean {
        var start = wordEnd
        while (start < lineEnd && isSpace(bytes[start])) start++
        var end = start
        while (end < lineEnd && !isSpace(bytes[end])) end++
        wordStart = start
        wordEnd = end
        return start < end
    }

    /** Moves to the next word of the text, on this line or a later one; returns false after the last word. */
    fun nextWordOfText(): Boolean {
        while (!nextWord()) {
            if (!nextLine()) return false
        }
        return true
    }

    /** Whether the rest of the line has no words. */
    fun isBlank(): Boolean {
        for (i in wordEnd until lineEnd) if (!isSpace(bytes[i])) return false
        return true
    }

    /** Returns the number of words in the rest of the line. Cost: linear in their length. */
    fun countWords(): Int {
        var count = 0
        for (i in wordEnd until lineEnd) {
            if (!isSpace(bytes[i]) && (i == wordEnd || isSpace(bytes[i - 1]))) count++
        }
        return count
    }

    /** Whether the word that was read last equals [word], ignoring case. [word] must be lower-case ASCII. */
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

    /** Returns the words in the rest of the line, separated by single spaces, and moves to the end of the line. */
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

        /** Splits [line] at white space. */
        fun words(line: String): List<String> {
            val tokens = StringTokenizer(line)
            return List(tokens.countTokens()) { tokens.nextToken() }
        }
    }
}
