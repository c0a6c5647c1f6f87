package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import java.io.BufferedReader
import java.io.Reader

/**
 * The statements of a material library that say colours and numbers, one at each [readLine], for `MtlReader`; texture
 * statements are kept here instead, because that parser takes the last word for the file's name.
 *
 * Where both `d` (opacity) and `Tr` (its opposite, not in the specification) are given, `d` counts. The parser behind
 * knows no line numbers; [number] tells which line it is at, also while it fails.
 */
internal class MtlStatements(text: ByteArray) : BufferedReader(Reader.nullReader()) {
    private val statements = Statements(text)

    /** For each `newmtl` so far, its texture statements by keyword. */
    val maps = ArrayList<Map<String, MtlMap>>()

    /** For each `newmtl` so far, whether it has a `d`. */
    val haveOpacity = ArrayList<Boolean>()

    /** The statement that was handed out last. */
    var statement = ""
        private set

    /** Number of the line on which the statement that was read last begins; lines count from 1. */
    val number: Int get() = statements.number

    /** Statements of textures for what is not drawn. */
    val unused = KindCounts()

    private var current = HashMap<String, MtlMap>()

    override fun readLine(): String? {
        while (statements.next()) {
            val statement = statements.statement()
            val keyword = statement.substringBefore(' ').lowercase()
            return prepared(keyword, statement) ?: continue
        }
        return null
    }

    /** Returns [statement], which begins with [keyword] in any case, as the parser should see it; null drops it. */
    private fun prepared(keyword: String, statement: String): String? {
        if (keyword == "newmtl") {
            current = HashMap()
            maps.add(current)
            haveOpacity.add(false)
        } else if (maps.isEmpty()) {
            return null
        }
        this.statement = statement
        return when (keyword) {
            // The parser knows the keyword in lower case only
            "newmtl" -> "newmtl" + statement.substring(keyword.length)
            "d" -> numbers().also { haveOpacity[haveOpacity.size - 1] = true }
            "tr" -> numbers().takeUnless { haveOpacity.last() }
            "kd", "ks", "ke", "ns", "illum" -> numbers()
            "map_kd", "map_d" -> null.also { current[keyword] = MtlMap.parse(statement.substring(keyword.length)) }
            else -> null.also { if (keyword.startsWith("map_") || keyword in MAPS) unused.add(keyword) }
        }
    }

    /** Returns the statement with the spellings of numbers that the parser does not know replaced. */
    private fun numbers(): String = TextLines.words(statements.withoutComment()).joinToString(" ") { word ->
        if (word.toFloatOrNull() != null) word else TextNumbers.parseFloat(word)?.toString() ?: word
    }

    private companion object {
        /** Keywords of textures that do not begin with `map_`. */
        val MAPS = setOf("bump", "decal", "disp", "norm", "refl")
    }
}
