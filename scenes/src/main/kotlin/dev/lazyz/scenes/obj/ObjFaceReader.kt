package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Statements
import dev.lazyz.scenes.text.TextLines

/**
 * Reads faces, whose corners are `v`, `v/vt`, `v//vn` or `v/vt/vn`. If only some corners of a face have texture
 * coordinates or normals, the face has none.
 */
internal class ObjFaceReader(
    private val source: Source,
    private val statements: Statements,
    private val counts: ObjCounts,
    private val faces: FaceTable,
) {
    /** Number of the part to which the next faces belong. */
    var part = 0

    private var hasTextures = false
    private var hasNormals = false

    /** Three numbers for each corner of the current face. */
    private var numbers = IntArray(3 * LEAST)

    /** Reads the current statement. */
    fun read() {
        statements.nextWord()
        val count = readPlainCorners()
        if (count >= 3) {
            faces.begin(part, statements.number)
            for (i in 0 until 3 * count step 3) faces.addCorner(numbers[i], numbers[i + 1], numbers[i + 2])
        } else {
            statements.restart()
            readAny()
        }
    }

    /**
     * A fast path for [readAny] that handles the faces of most files. Reads the corners into [numbers] and returns
     * their count. Returns -1 unless all corners have the same form, and only positive numbers of at most nine digits.
     */
    private fun readPlainCorners(): Int {
        val bytes = statements.bytes
        val end = statements.contentEnd()
        var at = statements.wordEnd
        var count = 0
        var kind = 0
        while (true) {
            while (at < end && TextLines.isSpace(bytes[at])) at++
            if (at == end) return count
            source.step()
            if (3 * count == numbers.size) numbers = numbers.copyOf(2 * numbers.size)
            numbers[3 * count] = -1
            numbers[3 * count + 1] = -1
            numbers[3 * count + 2] = -1
            var found = 0
            var place = 0
            while (true) {
                val start = at
                var value = 0
                while (at < end) {
                    val digit = bytes[at] - ZERO
                    if (digit !in 0..9) break
                    value = 10 * value + digit
                    at++
                }
                if (at - start > MOST_DIGITS || (at > start && value == 0)) return -1
                if (at > start) {
                    numbers[3 * count + place] = value - 1
                    found = found or (1 shl place)
                }
                if (++place == 3 || at == end || bytes[at] != SLASH) break
                at++
            }
            if (found and 1 == 0 || (at < end && !TextLines.isSpace(bytes[at]))) return -1
            if (count == 0) kind = found
            if (found != kind) return -1
            count++
        }
    }

    /** Reads the current statement, whose first word has been read. */
    private fun readAny() {
        val count = survey()
        if (count < 3) {
            source.warn("", "line ${statements.number}", ": a face of $count corners is left out")
            return
        }
        faces.begin(part, statements.number)
        statements.restart()
        while (statements.nextWord()) corner()
    }

    /** Returns the number of corners, and determines whether all of them have texture coordinates and normals. */
    private fun survey(): Int {
        hasTextures = true
        hasNormals = true
        var count = 0
        while (statements.nextWord()) {
            val first = slash(statements.wordStart)
            val second = slash(first + 1)
            if (second <= first + 1) hasTextures = false
            if (slash(second + 1) <= second + 1) hasNormals = false
            count++
        }
        return count
    }

    private fun corner() {
        val first = slash(statements.wordStart)
        val second = slash(first + 1)
        val third = slash(second + 1)
        if (third < statements.wordEnd) fail("\"${statements.word()}\" is more than three numbers")
        faces.addCorner(
            position(statements.wordStart, first),
            if (hasTextures) number(first + 1, second, counts.textureCount) else -1,
            if (hasNormals) number(second + 1, third, counts.normalCount) else -1,
        )
    }

    /** Returns the vertex number in the current word. [what] is the kind of statement, for error messages. */
    fun vertex(what: String): Int = position(statements.wordStart, slash(statements.wordStart), what)

    /** Returns the position of the next slash in the current word at [from] or after it, or the end of the word. */
    private fun slash(from: Int): Int {
        var at = from
        while (at < statements.wordEnd && statements.bytes[at] != SLASH) at++
        return minOf(at, statements.wordEnd)
    }

    private fun position(from: Int, until: Int, what: String = "face"): Int {
        val count = counts.vertexCount
        val number = number(from, until, count)
        if (number != ObjModel.NOWHERE) return number
        val word = statements.decoded(from, until)
        if (!word.startsWith('-')) fail("\"$word\" cannot number a vertex")
        source.fail(
            "line ${statements.number}",
            "the $what refers to number $word, counted backward, of the $count vertices before it",
            ObjModel.REFERENCE_REMEDY,
        )
    }

    /**
     * Parses the bytes from [from] to [until] (exclusive) and returns the number, counted from 0. [count] elements have
     * been read so far. Returns [ObjModel.NOWHERE] if the number is 0, too large for any file, or counts backward
     * beyond the first element.
     */
    private fun number(from: Int, until: Int, count: Int): Int {
        val isBackward = from < until && statements.bytes[from] == MINUS
        val start = if (isBackward) from + 1 else from
        var value = 0L
        var at = start
        while (at < until && value <= Int.MAX_VALUE) {
            val digit = statements.bytes[at] - ZERO
            if (digit !in 0..9) break
            value = 10 * value + digit
            at++
        }
        val isNumber = (at == until && at > start) || value > Int.MAX_VALUE
        if (!isNumber) fail("\"${statements.decoded(from, until)}\" cannot number a vertex")
        return when {
            value == 0L || value > Int.MAX_VALUE -> ObjModel.NOWHERE
            !isBackward -> (value - 1).toInt()
            value <= count -> (count - value).toInt()
            else -> ObjModel.NOWHERE
        }
    }

    private fun fail(problem: String): Nothing = source.fail(
        "line ${statements.number}",
        problem,
        "write v, v/vt, v//vn or v/vt/vn, counting from 1, or from -1 backward",
    )

    private companion object {
        /** Initial capacity, in corners. */
        const val LEAST = 4

        /** Numbers of up to this many digits fit into 32 bits. */
        const val MOST_DIGITS = 9
        const val ZERO = '0'.code
        const val MINUS = '-'.code.toByte()
        const val SLASH = '/'.code.toByte()
    }
}
