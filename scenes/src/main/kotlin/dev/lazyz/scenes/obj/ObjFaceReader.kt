package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.Source

/**
 * Reads faces, whose corners are `v`, `v/vt`, `v//vn` or `v/vt/vn`. What only some corners of a face have is left out
 * of all.
 */
internal class ObjFaceReader(
    private val source: Source,
    private val statements: Statements,
    private val model: ObjModel,
) {
    /** Number of the part that faces belong to. */
    var part = 0

    private var hasTextures = false
    private var hasNormals = false

    /** Reads the statement at hand. */
    fun read() {
        val count = survey()
        if (count < 3) {
            source.warn("line ${statements.number}: a face of $count corners is left out")
            return
        }
        model.faces.begin(part, statements.number)
        statements.restart()
        while (statements.nextWord()) corner()
    }

    /** Returns the number of corners, and finds out what all of them have. */
    private fun survey(): Int {
        statements.nextWord()
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
        model.faces.addCorner(
            position(statements.wordStart, first),
            if (hasTextures) number(first + 1, second, model.textures.size / 2) else -1,
            if (hasNormals) number(second + 1, third, model.normals.size / 3) else -1,
        )
    }

    /** Returns the number of the vertex that the word at hand names, of a [what]. */
    fun vertex(what: String): Int = position(statements.wordStart, slash(statements.wordStart), what)

    /** Returns where the word has its next slash from [from] on, or where it ends. */
    private fun slash(from: Int): Int {
        var at = from
        while (at < statements.wordEnd && statements.bytes[at] != SLASH) at++
        return minOf(at, statements.wordEnd)
    }

    private fun position(from: Int, until: Int, what: String = "face"): Int {
        val count = model.positions.size / 3
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
     * Returns the number that stands from [from] until [until], counted from 0; [count] stand before.
     * [ObjModel.NOWHERE] if it is 0, too large for any file, or counts backward beyond the first.
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
        const val ZERO = '0'.code
        const val MINUS = '-'.code.toByte()
        const val SLASH = '/'.code.toByte()
    }
}
