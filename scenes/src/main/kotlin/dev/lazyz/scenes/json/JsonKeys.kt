package dev.lazyz.scenes.json

import dev.lazyz.scenes.text.EditDistance

/** Helpers for JSON paths and misspelt keys. */
internal object JsonKeys {
    /** Returns the path of member [key] of the object at [path]. */
    fun path(path: String, key: String): String = when {
        !isIdentifier(key) -> "$path[\"$key\"]"
        path.isEmpty() -> key
        else -> "$path.$key"
    }

    private fun isIdentifier(key: String): Boolean {
        val first = key.firstOrNull() ?: return false
        return (isLetter(first) || first == '_') && key.all { isLetter(it) || it in '0'..'9' || it in "_-" }
    }

    private fun isLetter(character: Char): Boolean = character in 'a'..'z' || character in 'A'..'Z'

    /** Returns the word of [known] that differs the least from [key], in at most two edits, or null. */
    fun nearest(key: String, known: List<String>): String? =
        known.filter { StrictMath.abs(it.length - key.length) <= MAX_EDITS }
            .map { it to EditDistance.between(key, it) }
            .filter { (word, edits) -> edits <= MAX_EDITS && edits < word.length / 2 }
            .minByOrNull { it.second }
            ?.first

    private const val MAX_EDITS = 2
}
