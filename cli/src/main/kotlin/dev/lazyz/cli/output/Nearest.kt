package dev.lazyz.cli.output

import dev.lazyz.scenes.text.EditDistance

/** Finds the name that is most similar to a misspelt one. */
internal object Nearest {
    /** Returns `; did you mean 'x'?` for the name nearest to [text], or an empty string if none is near. */
    fun hint(text: String, names: Collection<String>): String =
        of(text, names)?.let { "; did you mean '$it'?" }.orEmpty()

    /**
     * Returns the nearest of [names]. If all differ from [text] by more than a third of its letters, returns the first
     * that begins with [text], provided that it has at least three letters, or null.
     */
    fun of(text: String, names: Collection<String>): String? {
        val wanted = text.lowercase()
        val best = names.minByOrNull { distance(wanted, it) } ?: return null
        val isNear = distance(wanted, best) <= wanted.length / 3
        return if (isNear) best else names.firstOrNull { wanted.length >= 3 && it.lowercase().startsWith(wanted) }
    }

    private fun distance(wanted: String, name: String): Int = EditDistance.between(wanted, name.lowercase())
}
