package dev.lazyz.scenes.text

import dev.lazyz.scenes.loading.Source
import java.io.IOException
import java.io.InputStream
import java.util.StringTokenizer

/**
 * Splits the text in a byte array into numbered lines, and lines into words. A line ends at a line feed, a carriage
 * return, or both. Words are separated by white space.
 *
 * Bytes are decoded as ISO 8859-1, which accepts any bytes. Not thread safe.
 *
 * @param window the text, or its beginning; holds at least the current line, and changes with the line
 * @param position index of the first line's first byte
 * @param firstLine number of the first line
 */
internal class TextLines(private val window: ByteWindow, position: Int = 0, firstLine: Int = 1) {
    /** Lines of all of [source]. */
    constructor(source: Source) : this(ByteWindow(source))

    /** The text around the current line. The indices below refer to it. */
    val bytes: ByteArray get() = window.bytes

    /** Number of [bytes] that are text. */
    private val size: Int get() = window.size

    /** Number of bytes of the text before the next line. */
    val passed: Long get() = window.passed + position

    /** Index where the next line begins. */
    var position = position
        private set

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
    val isCutOff: Boolean get() = lineEnd == size

    /** Returns the next line without its terminator, or null after the last line. Fails if it is longer than a name. */
    fun next(): String? = if (nextLine()) shortText(lineStart) else null

    /** Returns the text from [start] to the end of the line. Fails if it is longer than any name. */
    private fun shortText(start: Int): String {
        val length = lineEnd - start
        if (length > LONGEST_NAME) tooLong(window.source, number, LONGEST_NAME)
        window.source.step(length)
        return String(bytes, start, length, Charsets.ISO_8859_1)
    }

    /**
     * Moves to the next line, before its first word; returns false after the last line. Fails if the line has [LONGEST]
     * bytes or more.
     *
     * @throws IOException if the rest of the text cannot be read
     */
    fun nextLine(): Boolean {
        var end = position
        while (true) {
            val bytes = bytes
            val size = size
            val limit = position + minOf(size - position, LONGEST)
            while (end < limit && !isLineEnd(bytes[end])) end++
            if (end - position >= LONGEST) tooLong(window.source, number + 1, LONGEST)

            // A carriage return at the end can be half of a line's end
            val isComplete = end < size && (bytes[end] == LINE_FEED || end + 1 < size)
            if (isComplete || window.isAtEnd) break
            end -= position
            window.readMore(position)
            position = 0
        }
        if (position >= size) return false
        window.source.step(1 + (end - position) / BYTES_A_STEP)
        lineStart = position
        lineEnd = end
        wordEnd = position
        val isPair = end + 1 < size && bytes[end] == CARRIAGE_RETURN && bytes[end + 1] == LINE_FEED
        position = minOf(end + (if (isPair) 2 else 1), size)
        number++
        return true
    }

    /** Moves to the next word of the line; returns false after the last word. */
    fun nextWord(): Boolean {
        val bytes = bytes
        var start = wordEnd
        while (start < lineEnd && isSpace(bytes[start])) start++
        var end = start
        while (end < lineEnd && !isSpace(bytes[end])) end++
        wordStart = start
        wordEnd = end
        window.source.step()
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
    fun isWord(word: String): Boolean = wordEnd - wordStart == word.length && beginsWith(word)

    /** Whether the word that was read last begins with [start], ignoring case. [start] must be lower-case ASCII. */
    fun beginsWith(start: String): Boolean {
        if (wordEnd - wordStart < start.length) return false
        for (i in start.indices) {
            val byte = bytes[wordStart + i].toInt()
            val isUpper = byte >= 'A'.code && byte <= 'Z'.code
            if ((if (isUpper) byte + ('a' - 'A') else byte) != start[i].code) return false
        }
        return true
    }

    /** Returns the word that was read last. */
    fun word(): String = String(bytes, wordStart, wordEnd - wordStart, Charsets.ISO_8859_1)

    /**
     * Returns the words in the rest of the line, separated by single spaces, and moves to the end of the line. Fails if
     * they are longer than any name.
     */
    fun restOfLine(): String {
        val rest = words(shortText(wordEnd)).joinToString(" ")
        wordEnd = lineEnd
        return rest
    }

    /** Moves to the end of the line. */
    fun endLine() {
        wordEnd = lineEnd
    }

    companion object {
        /** Lines of a text must be shorter, in bytes. */
        const val LONGEST: Int = 1 shl 25

        /** The longest line, in bytes, that is a name or a header, and not a list of numbers. */
        const val LONGEST_NAME: Int = 1 shl 20

        /** About as many bytes are looked at in the time of a step. */
        const val BYTES_A_STEP: Int = 32

        /** Fails, because line [number] has at least [most] bytes. */
        fun tooLong(source: Source, number: Int, most: Int): Nothing =
            source.fail("line $number", "the line has $most bytes or more", "divide it, or export the model again")

        private const val SPACE = ' '.code.toByte()
        private const val TAB = '\t'.code.toByte()
        private const val FORM_FEED = '\u000C'.code.toByte()
        private const val LINE_FEED = '\n'.code.toByte()
        private const val CARRIAGE_RETURN = '\r'.code.toByte()

        /** Whether [byte] is white space within a line. */
        fun isSpace(byte: Byte): Boolean = byte <= SPACE && (byte == SPACE || byte == TAB || byte == FORM_FEED)

        // Most bytes are greater than all of these, so that one comparison is enough
        private fun isLineEnd(byte: Byte): Boolean =
            byte <= CARRIAGE_RETURN && (byte == LINE_FEED || byte == CARRIAGE_RETURN)

        /** Returns [name] without a trailing comment. In a name, only a `#` after a space begins one. */
        fun uncommented(name: String): String = name.substringBefore(" #").trimEnd()

        /** Splits [line] at white space. */
        fun words(line: String): List<String> {
            val tokens = StringTokenizer(line)
            return List(tokens.countTokens()) { tokens.nextToken() }
        }
    }
}

/**
 * The part of a file that is in memory while the file is read from its beginning to its end. Not thread safe.
 *
 * @property source the file, whose steps of work are counted
 * @param bytes the file, or its beginning
 * @param rest the rest of the file, or null if [bytes] is all of it
 * @param passed number of bytes of the file before [bytes]
 */
internal class ByteWindow(
    val source: Source,
    bytes: ByteArray = source.bytes,
    private val rest: InputStream? = null,
    passed: Long = 0,
) {
    /** The rest of a file of which nothing is in memory yet. The [rest] begins after [passed] bytes. */
    constructor(source: Source, rest: InputStream, passed: Long = 0) : this(source, ByteArray(0), rest, passed)

    /** The bytes in memory. Indices refer to it. It changes in [readMore]. */
    var bytes: ByteArray = bytes
        private set

    /** Number of [bytes] that are of the file. */
    var size: Int = bytes.size
        private set

    /** Whether the file ends at [size]. */
    var isAtEnd: Boolean = rest == null
        private set

    /** Number of bytes of the file before index 0. */
    var passed: Long = passed
        private set

    /** Whether only a part of the file is in memory. */
    val isPart: Boolean get() = rest != null

    /**
     * Moves the bytes from index [from] on to the front, and reads what follows them, until there are [least] bytes or
     * the file ends. Call it only if the file does not end at [size].
     *
     * @throws IOException if the file cannot be read
     */
    fun readMore(from: Int, least: Int = 0) {
        val kept = size - from
        val old = bytes
        val isFull = kept >= old.size / 2
        if (isFull || old.size < least) bytes = ByteArray(maxOf(PIECE, least, if (isFull) 2 * old.size else 0))
        System.arraycopy(old, from, bytes, 0, kept)
        passed += from
        source.loading.look(source.name)
        val count = checkNotNull(rest).readNBytes(bytes, kept, bytes.size - kept)
        size = kept + count
        isAtEnd = size < bytes.size
    }

    private companion object {
        /** Bytes that are in memory at a time, unless more are needed. */
        const val PIECE = 1 shl 20
    }
}
