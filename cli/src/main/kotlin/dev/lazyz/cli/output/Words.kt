package dev.lazyz.cli.output

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Returns [number] with separators, and what it counts: [one] if the number is 1, otherwise [several]. `1 picture`,
 * `1,200 pictures`.
 */
internal fun counted(number: Long, one: String, several: String = "${one}s"): String =
    "%,d %s".format(null, number, if (number == 1L) one else several)

/** Returns [text] on one line, with `?` for control characters, which a terminal would execute. */
internal fun printable(text: String): String = text.map { if (it.isISOControl()) '?' else it }.joinToString("")

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

/** Formats JSON (RFC 8259) as one line of ASCII. */
internal object Json {
    /**
     * Returns [element] as text. Characters outside ASCII can only be in its strings; they are escaped, so that the
     * encoding of standard error does not matter, and file names that are not legal Unicode remain distinct.
     */
    fun of(element: JsonElement): String = buildString {
        for (character in element.toString()) {
            if (character in ' '..'~') append(character) else append("\\u%04x".format(null, character.code))
        }
    }

    /** Returns [data], which consists of maps, lists, numbers, booleans, texts and null, as JSON. */
    fun element(data: Any?): JsonElement = when (data) {
        null -> JsonNull
        is Map<*, *> -> JsonObject(data.entries.associate { (name, value) -> "$name" to element(value) })
        is List<*> -> JsonArray(data.map(::element))
        else -> primitive(data)
    }

    /** Returns [value], which is a number, a boolean or a text, as JSON. */
    fun primitive(value: Any): JsonPrimitive = when (value) {
        is Number -> JsonPrimitive(value)
        is Boolean -> JsonPrimitive(value)
        else -> JsonPrimitive(value as String)
    }
}
