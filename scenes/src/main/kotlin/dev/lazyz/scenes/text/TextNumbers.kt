package dev.lazyz.scenes.text

/**
 * Parses numbers as various programs write them in mesh files. NaN and infinity are accepted in C's spellings (`nan`,
 * `-nan(ind)`, `inf`) and in Microsoft's (`1.#QNAN`, `1.#INF`), ignoring case. Some exporters write the sign before
 * the `e` by mistake: `3.1+e2` is read as `3.1e+2`.
 */
internal object TextNumbers {
    /** Returns the number that [word] represents, or null if it is not a number. */
    fun parse(word: String): Double? = word.toDoubleOrNull() ?: named(word) ?: corrected(word)?.toDoubleOrNull()

    /** Returns the float nearest to the number that [word] represents, or null if it is not a number. */
    fun parseFloat(word: String): Float? =
        word.toFloatOrNull() ?: named(word)?.toFloat() ?: corrected(word)?.toFloatOrNull()

    /** Returns [word] with the sign behind the `e`, or null if it is not in front of it. */
    private fun corrected(word: String): String? {
        val e = word.indexOf('e', ignoreCase = true)
        if (e < 2 || word[e - 1] !in "+-" || word.last() !in '0'..'9') return null
        return word.substring(0, e - 1) + "e" + word[e - 1] + word.substring(e + 1)
    }

    private fun named(word: String): Double? {
        val isNegative = word.startsWith("-")
        val name = word.removePrefix("-").removePrefix("+").lowercase()
        return when {
            name.startsWith("nan") || name.startsWith("1.#qnan") || name.startsWith("1.#snan") -> Double.NaN
            name.startsWith("1.#ind") -> Double.NaN
            name == "inf" || name == "infinity" || name.startsWith("1.#inf") ->
                if (isNegative) Double.NEGATIVE_INFINITY else Double.POSITIVE_INFINITY
            else -> null
        }
    }

    /**
     * Returns a remedy for [word], which is not a number, or null. A comma that is not between digits is no decimal
     * one.
     */
    fun remedy(word: String): String? = when {
        ',' !in word -> null
        '.' in word || word.count { it == ',' } > 1 || word.startsWith(',') || word.endsWith(',') ->
            "write spaces between numbers, not commas"
        else -> "write numbers with a decimal point, not a comma"
    }
}
