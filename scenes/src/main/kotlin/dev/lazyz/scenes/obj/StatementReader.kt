package dev.lazyz.scenes.obj

import java.io.BufferedReader
import java.io.StringReader
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException

/**
 * The statements of an OBJ or MTL text, one at each [readLine], made fit for a parser of plain lines.
 *
 * Lines that end with a backslash are joined with the next, tabs become spaces, empty lines and comment lines fall out,
 * and [prepare] may rewrite or drop the rest. The parser behind knows no line numbers; [number] tells which line it is
 * at, also while it fails.
 */
internal abstract class StatementReader(text: String) : BufferedReader(StringReader(text)) {
    private var lines = 0

    /** Number of the line on which the statement that was read last begins; lines count from 1. */
    var number = 0
        private set

    /** Returns [statement], which begins with [keyword] in any case, as the parser should see it; null drops it. */
    protected abstract fun prepare(keyword: String, statement: String): String?

    final override fun readLine(): String? {
        while (true) {
            val statement = joined() ?: return null
            if (statement.isEmpty() || statement.startsWith("#")) continue
            val keyword = statement.substringBefore(' ').lowercase()
            return prepare(keyword, statement) ?: continue
        }
    }

    private fun joined(): String? {
        var line = physicalLine() ?: return null
        number = lines
        if (!line.endsWith("\\")) return line
        val joined = StringBuilder()
        while (line.endsWith("\\")) {
            joined.append(line, 0, line.length - 1).append(' ')
            line = physicalLine() ?: ""
        }
        return joined.append(line).toString().trim()
    }

    private fun physicalLine(): String? {
        val line = super.readLine() ?: return null
        lines++
        return line.replace('\t', ' ').trim()
    }

    companion object {
        private const val BYTE_ORDER_MARK = "\uFEFF"

        /** Decodes UTF-8, or ISO 8859-1 where the bytes are not UTF-8. */
        fun decode(bytes: ByteArray): String = try {
            Charsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString().removePrefix(BYTE_ORDER_MARK)
        } catch (_: CharacterCodingException) {
            String(bytes, Charsets.ISO_8859_1)
        }

        /**
         * Returns [statement] without a comment at its end; not for names, which may hold a `#`. Behind a point the `#`
         * belongs to Microsoft's `1.#IND`.
         */
        fun withoutComment(statement: String): String {
            val start = statement.indices.firstOrNull { statement[it] == '#' && (it == 0 || statement[it - 1] != '.') }
            return if (start == null) statement else statement.substring(0, start).trimEnd()
        }
    }
}
