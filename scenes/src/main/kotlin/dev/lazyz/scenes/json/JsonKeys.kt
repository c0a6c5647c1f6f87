package dev.lazyz.scenes.json

import dev.lazyz.scenes.text.EditDistance

/** Helpers for JSON paths, misspelt keys and the grammar of numbers. */
internal object JsonKeys {
    private val identifier = Regex("[A-Za-z_][A-Za-z0-9_-]*")

    /** Returns the path of member [key] of the object at [path]. */
    fun path(path: String, key: String): String = when {
        !key.matches(identifier) -> "$path[\"$key\"]"
        path.isEmpty() -> key
        else -> "$path.$key"
    }

    /** Returns the word of [known] that differs the least from [key], in at most two edits, or null. */
    fun nearest(key: String, known: List<String>): String? =
        known.filter { StrictMath.abs(it.length - key.length) <= MAX_EDITS }
            .map { it to EditDistance.between(key, it) }
            .filter { (word, edits) -> edits <= MAX_EDITS && edits < word.length / 2 }
            .minByOrNull { it.second }
            ?.first

    /** Whether [text] is a number by JSON's grammar (RFC 8259, section 6). */
    fun isNumber(text: String): Boolean {
        var i = if (text.startsWith('-')) 1 else 0
        val wholeStart = i
        i = skipDigits(text, i)
        if (i == wholeStart || (text[wholeStart] == '0' && i > wholeStart + 1)) return false
        if (i < text.length && text[i] == '.') {
            val end = skipDigits(text, i + 1)
            if (end == i + 1) return false
            i = end
        }
        if (i < text.length && (text[i] == 'e' || text[i] == 'E')) {
            i++
            if (i < text.length && (text[i] == '+' || text[i] == '-')) i++
            val end = skipDigits(text, i)
            if (end == i) return false
            i = end
        }
        return i == text.length
    }

    private fun skipDigits(text: String, start: Int): Int {
        var i = start
        while (i < text.length && text[i] in '0'..'9') i++
        return i
    }

    private const val MAX_EDITS = 2
}
