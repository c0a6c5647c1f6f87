package dev.lazyz.cli.output

import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonPrimitive

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

    /** Returns [value], which is a number, a boolean or a text, as JSON. */
    fun primitive(value: Any): JsonPrimitive = when (value) {
        is Number -> JsonPrimitive(value)
        is Boolean -> JsonPrimitive(value)
        else -> JsonPrimitive(value as String)
    }
}
