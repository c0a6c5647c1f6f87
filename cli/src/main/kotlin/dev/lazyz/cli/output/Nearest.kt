package dev.lazyz.cli.output

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
        val best = names.minByOrNull { distance(wanted, it.lowercase()) } ?: return null
        val isNear = distance(wanted, best.lowercase()) <= wanted.length / 3
        return if (isNear) best else names.firstOrNull { wanted.length >= 3 && it.lowercase().startsWith(wanted) }
    }

    /** Returns the number of insertions, deletions, replacements and swaps of adjacent letters from [a] to [b]. */
    private fun distance(a: String, b: String): Int {
        var beforeLast = IntArray(b.length + 1)
        var last = IntArray(b.length + 1) { it }
        for (i in 1..a.length) {
            val row = IntArray(b.length + 1)
            row[0] = i
            for (j in 1..b.length) {
                val replaced = last[j - 1] + if (a[i - 1] == b[j - 1]) 0 else 1
                row[j] = minOf(last[j] + 1, row[j - 1] + 1, replaced)
                val isExchange = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]
                if (isExchange) row[j] = minOf(row[j], beforeLast[j - 2] + 1)
            }
            beforeLast = last
            last = row
        }
        return last[b.length]
    }
}
