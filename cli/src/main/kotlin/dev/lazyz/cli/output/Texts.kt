package dev.lazyz.cli.output

import dev.lazyz.scenes.text.EditDistance

/** Formats and parses amounts of memory. */
internal object Bytes {
    private val units = listOf("bytes", "KiB", "MiB", "GiB", "TiB")
    private val powers =
        listOf(setOf("", "b", "bytes")) + listOf("k", "m", "g", "t").map { setOf(it, "${it}i", "${it}ib") }

    /** Returns [bytes] in the largest unit in which the amount is at least 1, with one decimal: `5.9 GiB`. */
    fun readable(bytes: Long): String {
        var unit = 0
        var tenths = bytes * 10
        while (tenths >= 10 * 1024 && unit < units.size - 1) {
            tenths /= 1024
            unit++
        }
        return if (unit == 0) "$bytes bytes" else "${tenths / 10}.${tenths % 10} ${units[unit]}"
    }

    /**
     * Returns the number of bytes that [text] means, or null if it is not an amount: an integer, alone or with k, m, g
     * or t, or with KiB, MiB and so on, in steps of 1024. Amounts above [Long.MAX_VALUE] become [Long.MAX_VALUE]. `kB`
     * is not accepted, because it may also mean 1000 bytes.
     */
    fun parse(text: String): Long? {
        val digits = text.takeWhile { it in '0'..'9' }
        val unit = text.substring(digits.length).removePrefix(" ").lowercase()
        val power = powers.indexOfFirst { unit in it }
        if (digits.isEmpty() || power < 0) return null
        val shift = 10 * power
        val number = digits.toLongOrNull() ?: Long.MAX_VALUE
        return if (number > Long.MAX_VALUE shr shift) Long.MAX_VALUE else number shl shift
    }
}

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
