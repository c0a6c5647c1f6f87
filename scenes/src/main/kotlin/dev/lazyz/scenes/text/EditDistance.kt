package dev.lazyz.scenes.text

/**
 * Measures how much two words differ, for suggestions such as `did you mean "lights"?`.
 *
 * It is the "optimal string alignment" variant of the distance of Damerau, "A technique for computer detection and
 * correction of spelling errors" (1964): no letter is edited twice.
 */
public object EditDistance {
    /**
     * Returns the number of insertions, deletions, replacements and swaps of adjacent letters that turn [a] into [b],
     * 0 if they are equal. Upper and lower case differ. The time is proportional to the product of the lengths.
     */
    @JvmStatic
    public fun between(a: String, b: String): Int {
        var beforeLast = IntArray(b.length + 1)
        var last = IntArray(b.length + 1) { it }
        for (i in 1..a.length) {
            val row = IntArray(b.length + 1)
            row[0] = i
            for (j in 1..b.length) {
                val replaced = last[j - 1] + if (a[i - 1] == b[j - 1]) 0 else 1
                row[j] = minOf(last[j] + 1, row[j - 1] + 1, replaced)
                val isSwap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]
                if (isSwap) row[j] = minOf(row[j], beforeLast[j - 2] + 1)
            }
            beforeLast = last
            last = row
        }
        return last[b.length]
    }

    /**
     * Returns the nearest of [names], without regard to upper and lower case. If all differ from [word] by more than a
     * third of its letters, returns the first that begins with [word], provided that it has at least three letters, or
     * null.
     */
    @JvmStatic
    public fun nearest(word: String, names: Collection<String>): String? {
        val wanted = word.lowercase()
        val best = names.minByOrNull { between(wanted, it.lowercase()) } ?: return null
        val isNear = between(wanted, best.lowercase()) <= wanted.length / 3
        return if (isNear) best else names.firstOrNull { wanted.length >= 3 && it.lowercase().startsWith(wanted) }
    }

    /** Returns `; did you mean 'x'?` for the [nearest] of [names], or an empty string if none is near. */
    @JvmStatic
    public fun hint(word: String, names: Collection<String>): String =
        nearest(word, names)?.let { "; did you mean '$it'?" }.orEmpty()
}
