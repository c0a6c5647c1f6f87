package dev.lazyz.scenes.text

import dev.lazyz.scenes.loading.Source
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.CharBuffer
import java.nio.charset.Charset

/**
 * The statements of an OBJ or MTL text, and their words.
 *
 * A line that ends with a backslash is joined with the next one, unless it ends with a comment. White space around a
 * statement is removed. Empty lines and comment lines are skipped. The text must not have a byte order mark. Names are
 * UTF-8, or ISO 8859-1 if the text is not valid UTF-8; if the text is not in memory, this is decided for each word. Not
 * thread safe.
 *
 * @param window the text, or its beginning; holds at least the current line, and changes with the line
 */
internal class Statements(private val window: ByteWindow) {
    /** The statements of all of [text], which is all of [source] or of a file that it refers to. */
    constructor(source: Source, text: ByteArray = source.bytes) : this(ByteWindow(source, text))

    private val source = window.source
    private val text: ByteArray get() = window.bytes
    private val charset by lazy { charset(text) }
    private var position = 0
    private var lines = 0

    /** The first line of the statement that was read last, counted from 1. */
    var number = 0
        private set

    /** The bytes that contain the statement's words: the text, or a copy of several joined lines. */
    var bytes: ByteArray = window.bytes
        private set
    private var start = 0
    private var end = 0

    /** The end of the statement without a trailing comment, or -1 until it is computed. */
    private var knownEnd = 0
    private var mayHaveComment = false

    /** The start of the word that was read last. */
    var wordStart = 0
        private set

    /** The end (exclusive) of the word that was read last. */
    var wordEnd = 0
        private set

    /** Moves to the next statement, before its first word. Returns false after the last one. */
    fun next(): Boolean {
        do {
            if (!hasMore()) return false
            mayHaveComment = false
            readLine()
            bytes = text
            number = lines
            if (isContinued()) join()
        } while (start == end || bytes[start] == HASH)
        knownEnd = if (mayHaveComment) -1 else end
        wordEnd = start
        return true
    }

    /**
     * Whether the statement begins with [keyword], which is given in lower case. Case is ignored. A keyword ends at a
     * space.
     */
    fun hasKeyword(keyword: String): Boolean {
        val after = start + keyword.length
        if (after > end || (after < end && bytes[after] != SPACE && bytes[after] != TAB)) return false
        for (i in keyword.indices) {
            val byte = bytes[start + i].toInt()
            val isUpper = byte >= 'A'.code && byte <= 'Z'.code
            if ((if (isUpper) byte + ('a' - 'A') else byte) != keyword[i].code) return false
        }
        return true
    }

    /** Returns the statement with tabs replaced by spaces. */
    fun statement(): String = decoded(start, end)

    /**
     * Returns the statement without a trailing comment. Not for names, which may contain a `#`. A `#` after a point
     * does not begin a comment: it is part of Microsoft's `1.#IND`.
     */
    fun withoutComment(): String = decoded(start, contentEnd()).trimEnd()

    /** Moves to the next word; the first is the keyword. Returns false at the end of the statement or at a comment. */
    fun nextWord(): Boolean {
        val bytes = bytes
        val limit = contentEnd()
        var from = wordEnd
        while (from < limit && TextLines.isSpace(bytes[from])) from++
        var until = from
        while (until < limit && !TextLines.isSpace(bytes[until])) until++
        wordStart = from
        wordEnd = until
        source.step()
        return from < until
    }

    /** Returns the first word, in lower case. */
    fun keyword(): String {
        restart()
        return word().lowercase()
    }

    /** Moves back to the keyword, so that it is the word that was read last. */
    fun restart() {
        wordEnd = start
        nextWord()
    }

    /** Returns the word that was read last. */
    fun word(): String = decoded(wordStart, wordEnd)

    /**
     * Returns the text of [bytes] from [from] to [until] (exclusive), with tabs replaced by spaces. Fails if it is
     * longer than any name.
     */
    fun decoded(from: Int, until: Int): String {
        if (until - from > TextLines.LONGEST_NAME) TextLines.tooLong(source, number, TextLines.LONGEST_NAME)
        source.step(until - from)
        val used = if (window.isPart) charset(bytes.copyOfRange(from, until)) else charset
        return String(bytes, from, until - from, used).replace('\t', ' ')
    }

    /** Returns the end of the statement in [bytes], without a trailing comment. */
    fun contentEnd(): Int {
        if (knownEnd < 0) {
            knownEnd = start
            while (knownEnd < end && !isComment(knownEnd)) knownEnd++
        }
        return knownEnd
    }

    private fun isComment(at: Int): Boolean = bytes[at] == HASH && (at == start || bytes[at - 1] != POINT)

    /** Whether the text goes on at [position]. */
    private fun hasMore(): Boolean {
        if (position < window.size) return true
        if (window.isAtEnd) return false
        window.readMore(position)
        position = 0
        return window.size > 0
    }

    /** Finds the next line of the text, without the white space around it. */
    private fun readLine() {
        var after = position
        while (true) {
            val text = text
            val size = window.size
            val limit = position + minOf(size - position, TextLines.LONGEST)
            while (after < limit) {
                val byte = text[after]
                // Digits and letters are greater than all of these
                if (byte <= HASH) {
                    if (byte == LINE_FEED || byte == CARRIAGE_RETURN) break
                    if (byte == HASH) mayHaveComment = true
                }
                after++
            }

            if (after - position >= TextLines.LONGEST) TextLines.tooLong(source, lines + 1, TextLines.LONGEST)

            // A carriage return at the end can be half of a line's end
            val isComplete = after < size && (text[after] == LINE_FEED || after + 1 < size)
            if (isComplete || window.isAtEnd) break
            after -= position
            window.readMore(position)
            position = 0
        }
        source.step(1 + (after - position) / TextLines.BYTES_A_STEP)
        start = position
        end = after
        trim(text)
        val isPair = after + 1 < window.size && text[after] == CARRIAGE_RETURN && text[after + 1] == LINE_FEED
        position = minOf(after + (if (isPair) 2 else 1), window.size)
        lines++
    }

    /** Whether the line that was read last ends with a backslash that is not part of a comment. */
    private fun isContinued(): Boolean {
        if (start == end || text[end - 1] != BACKSLASH) return false
        for (at in start until end) if (text[at] == HASH && (at == start || text[at - 1] != POINT)) return false
        return true
    }

    /** Joins the line with the next one, separated by a space, for as long as lines end with a backslash. */
    private fun join() {
        val joined = ByteArrayOutputStream()
        var isOpen = true
        while (isOpen) {
            isOpen = isContinued()
            joined.write(text, start, end - start - (if (isOpen) 1 else 0))
            if (!isOpen || !hasMore()) break
            if (joined.size() >= TextLines.LONGEST) TextLines.tooLong(source, number, TextLines.LONGEST)
            joined.write(SPACE.toInt())
            readLine()
        }
        bytes = joined.toByteArray()
        start = 0
        end = bytes.size
        trim(bytes)
    }

    private fun trim(bytes: ByteArray) {
        while (start < end && isBlank(bytes[start])) start++
        while (start < end && isBlank(bytes[end - 1])) end--
    }

    private fun charset(bytes: ByteArray): Charset = if (isUtf8(bytes)) Charsets.UTF_8 else Charsets.ISO_8859_1

    private fun isUtf8(bytes: ByteArray): Boolean {
        val decoder = Charsets.UTF_8.newDecoder()
        val input = ByteBuffer.wrap(bytes)
        val output = CharBuffer.allocate(4096)
        while (true) {
            val result = decoder.decode(input, output.clear(), true)
            source.step(output.position() / TextLines.BYTES_A_STEP)
            if (result.isError) return false
            if (result.isUnderflow) return true
        }
    }

    private companion object {
        const val SPACE = ' '.code.toByte()
        const val TAB = '\t'.code.toByte()
        const val LINE_FEED = '\n'.code.toByte()
        const val CARRIAGE_RETURN = '\r'.code.toByte()
        const val BACKSLASH = '\\'.code.toByte()
        const val HASH = '#'.code.toByte()
        const val POINT = '.'.code.toByte()

        /** Whether [byte] is a space or a control character. */
        fun isBlank(byte: Byte) = byte in 0..SPACE
    }
}
