package dev.lazyz.cli.output

/** Writes JSON (RFC 8259) in one line of ASCII. */
internal object Json {
    /** Returns [value], a map with keys in their order, a list, a string, a number, a boolean or null, as JSON. */
    fun of(value: Any?): String = when (value) {
        null, is Number, is Boolean -> value.toString()
        is String -> quoted(value)
        is List<*> -> value.joinToString(", ", "[", "]") { of(it) }
        is Map<*, *> -> value.entries.joinToString(", ", "{", "}") { (key, item) -> "\"$key\": ${of(item)}" }
        else -> error("no JSON for ${value.javaClass.name}")
    }

    private fun quoted(text: String): String = buildString {
        append('"')
        for (char in text) {
            when {
                char == '"' || char == '\\' -> append('\\').append(char)
                char in ' '..'~' -> append(char)
                else -> append("\\u").append(char.code.toString(16).padStart(4, '0'))
            }
        }
        append('"')
    }
}
