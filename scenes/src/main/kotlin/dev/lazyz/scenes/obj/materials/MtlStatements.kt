package dev.lazyz.scenes.obj.materials

import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Statements
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import java.io.BufferedReader
import java.io.Reader

/**
 * The statements of a material library that give colours and numbers, one for each [readLine], for `MtlReader`. Texture
 * statements are stored in [maps] instead, because that parser takes the last word as the file name.
 *
 * If an entry has both `d` (opacity) and `Tr` (its opposite, not in the specification), `d` is used. `MtlReader` does
 * not report line numbers; [number] is the current line, also after `MtlReader` has failed.
 */
internal class MtlStatements(private val library: Source) : BufferedReader(Reader.nullReader()) {
    private val statements = Statements(library)

    /** For each `newmtl` so far, its texture statements by keyword. */
    val maps = ArrayList<Map<String, MtlMap>>()

    /** For each `newmtl` so far, whether it has a `d`. */
    val haveOpacity = ArrayList<Boolean>()

    /** For each `newmtl` so far, its numbers such as `pm`, as far as they are given. */
    val model = ArrayList<HashMap<String, Float>>()

    /** The statement that was returned last. */
    var statement = ""
        private set

    /** The first line of the statement that was read last, counted from 1. */
    val number: Int get() = statements.number

    /** Statements for features that are not rendered, except those that would change nothing. */
    val unused = KindCounts()

    private var current = HashMap<String, MtlMap>()

    override fun readLine(): String? {
        while (statements.next()) {
            val statement = statements.statement()
            if (statement.length > LONGEST) TextLines.tooLong(library, number, LONGEST)
            val keyword = statement.substringBefore(' ').lowercase()
            return prepared(keyword, statement) ?: continue
        }
        return null
    }

    /**
     * Returns [statement] in the form that the parser expects, or null to drop it. [keyword] is its first word in lower
     * case.
     */
    private fun prepared(keyword: String, statement: String): String? {
        if (keyword == "newmtl") {
            current = HashMap()
            maps.add(current)
            library.loading.items(library, 1)
            haveOpacity.add(false)
            model.add(HashMap())
        } else if (maps.isEmpty()) {
            return null
        }
        this.statement = statement
        return when (keyword) {
            // The parser accepts the keyword in lower case only
            "newmtl" -> "newmtl" + statement.substring(keyword.length)
            "d" -> numbers().also { haveOpacity[haveOpacity.size - 1] = true }
            "tr" -> numbers().takeUnless { haveOpacity.last() }
            "kd", "ks", "ke", "ns", "illum" -> numbers()
            "pm", "pr", "pc", "pcr", "ps", "aniso", "anisor" -> null.also { setModel(keyword) }
            in USED_MAPS -> null.also { current[keyword] = MtlMap.parse(statement.substring(keyword.length)) }
            else -> null.also { setUnused(keyword) }
        }
    }

    private fun setUnused(keyword: String) {
        val isTexture = keyword.startsWith("map_") || keyword in MAPS
        if (!isTexture && (keyword !in NEUTRAL || isNeutral(keyword))) return
        unused.add(keyword)
    }

    /** Returns whether all numbers of the statement are such that it changes nothing. */
    private fun isNeutral(keyword: String): Boolean =
        TextLines.words(statements.withoutComment()).drop(1).all { TextNumbers.parseFloat(it) == NEUTRAL[keyword] }

    private fun setModel(keyword: String) {
        val word = TextLines.words(statements.withoutComment()).getOrNull(1) ?: return
        val number = word.toFloatOrNull() ?: TextNumbers.parseFloat(word) ?: return
        if (number.isFinite()) model.last()[keyword] = number.coerceIn(0f, 1f)
    }

    /** Returns the statement with numbers rewritten if the parser does not accept their spelling. */
    private fun numbers(): String = TextLines.words(statements.withoutComment()).joinToString(" ") { word ->
        if (word.toFloatOrNull() != null) word else TextNumbers.parseFloat(word)?.toString() ?: word
    }

    private companion object {
        /** The longest statement, in characters: some names of files and some numbers. */
        const val LONGEST = 1 shl 14

        /** Keywords of the texture statements that are rendered. */
        val USED_MAPS = setOf("map_kd", "map_d", "map_ke", "map_bump", "bump", "norm", "map_pm", "map_pr")

        /** Keywords of other texture statements that do not begin with `map_`. */
        val MAPS = setOf("decal", "disp", "refl")

        /** Keywords of numbers that are not rendered, each with the number that changes nothing: transmitted light. */
        val NEUTRAL = mapOf("tf" to 1f)
    }
}
