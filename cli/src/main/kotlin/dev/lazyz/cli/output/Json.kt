package dev.lazyz.cli.output

/** Formats JSON (RFC 8259) as one line of ASCII. */
internal object Json {
    /** Returns [value] as JSON: a map (keys keep their order), a list, a string, a number, a boolean or null. */
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
