package dev.lazyz.scenes.json

/** Writes indented JSON incrementally, so that the text of a large mesh is never in memory. */
internal class JsonWriter(private val out: Appendable) {
    private var depth = 0
    private var isFirst = true

    /** Writes an object whose members [content] writes. */
    inline fun members(content: JsonWriter.() -> Unit) {
        open('{')
        content()
        close('}')
    }

    /** Writes a list, with each item on its own line. */
    inline fun <T> items(items: Iterable<T>, write: JsonWriter.(T) -> Unit) {
        open('[')
        for (item in items) {
            next()
            write(item)
        }
        close(']')
    }

    /** Writes a member's key. The caller must write the value next. */
    fun key(name: String): JsonWriter = apply {
        next()
        text(name)
        out.append(": ")
    }

    /** Writes a text. Half of a pair of surrogates, which readers of JSON refuse, becomes the replacement character. */
    fun text(value: String) {
        out.append('"')
        var previous = ' '
        for ((index, char) in value.withIndex()) {
            val isHalf = if (char.isHighSurrogate()) {
                !value.getOrElse(index + 1) { ' ' }.isLowSurrogate()
            } else {
                char.isLowSurrogate() && !previous.isHighSurrogate()
            }
            when {
                isHalf -> out.append("\\ufffd")
                char == '"' || char == '\\' -> out.append('\\').append(char)
                char < ' ' || char.isSurrogate() -> out.append("\\u%04x".format(char.code))
                else -> out.append(char)
            }
            previous = char
        }
        out.append('"')
    }

    fun integer(value: Int) {
        out.append(value.toString())
    }

    fun float(value: Float) = literal(value.toString(), value.isFinite())

    fun double(value: Double) = literal(value.toString(), value.isFinite())

    /** Writes a short list on one line. */
    fun doubles(vararg values: Double) = inline(values.size) { double(values[it]) }

    /** Writes a short list on one line. */
    fun floats(vararg values: Float) = inline(values.size) { float(values[it]) }

    /** Writes a short list on one line. */
    fun integers(vararg values: Int) = inline(values.size) { integer(values[it]) }

    /** Writes a long list with [PER_LINE] numbers per line: a whole number of points, of pairs and of colours. */
    inline fun long(count: Int, write: (Int) -> Unit) {
        if (count == 0) return inline(0) { }
        open('[')
        for (i in 0 until count) {
            if (i % PER_LINE == 0) next() else append(", ")
            write(i)
        }
        close(']')
    }

    fun inline(count: Int, write: (Int) -> Unit) {
        out.append('[')
        for (i in 0 until count) {
            if (i > 0) out.append(", ")
            write(i)
        }
        out.append(']')
    }

    fun open(bracket: Char) {
        out.append(bracket)
        depth++
        isFirst = true
    }

    fun close(bracket: Char) {
        depth--
        if (!isFirst) newLine()
        out.append(bracket)
        isFirst = false
    }

    /** Begins the next member or item. */
    fun next() {
        if (!isFirst) out.append(',')
        isFirst = false
        newLine()
    }

    fun append(text: String) {
        out.append(text)
    }

    /** Removes the `.0` of whole numbers, and puts numbers that JSON cannot represent in quotes. */
    private fun literal(text: String, isFinite: Boolean) {
        if (isFinite) out.append(text.removeSuffix(".0")) else text(text)
    }

    private fun newLine() {
        out.append('\n')
        repeat(depth) { out.append("  ") }
    }

    override fun toString(): String = "JsonWriter(depth $depth)"

    companion object {
        const val PER_LINE: Int = 12
    }
}
