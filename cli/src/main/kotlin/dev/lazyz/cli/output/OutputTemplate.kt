package dev.lazyz.cli.output

import dev.lazyz.scenes.text.EditDistance
/** What stands in braces in `-o`, and is replaced by something of the picture. */
internal enum class Placeholder {
    /** The folder of the input. */
    DIR,

    /** The name of the input without folder and extension. */
    STEM,

    /** The name of the input without folder. */
    NAME,

    /** The extension of the input, without a dot. */
    EXT,

    /** The side from which the picture is seen. */
    VIEW,

    /** The number of the input, from 1. */
    INDEX,

    /** The number of the step of a turntable, from 1. */
    FRAME,
    ;

    val word: String get() = "{${name.lowercase()}}"
}

/**
 * The name of a file with placeholders: `{stem}_{view}.png`. Two braces, `{{` or `}}`, stand for one.
 *
 * @throws Mistake if a placeholder is unknown, or a brace is not closed
 */
internal class OutputTemplate(val text: String) {
    /** Texts and placeholders, in their order. */
    private val parts: List<Any> = parse()

    /** The placeholders in it. */
    val placeholders: Set<Placeholder> = parts.filterIsInstance<Placeholder>().toSet()

    /** The name of the only file, or null if there are placeholders. */
    val name: String? get() = if (placeholders.isEmpty()) expand { it.word } else null

    /** Returns the name of a file; [value] returns what replaces a placeholder. */
    fun expand(value: (Placeholder) -> String): String =
        parts.joinToString("") { if (it is Placeholder) value(it) else it as String }

    private fun parse(): List<Any> {
        val found = ArrayList<Any>()
        var at = 0
        while (at < text.length) {
            val open = text.indexOf('{', at)
            found.add((if (open < 0) text.substring(at) else text.substring(at, open)).replace("}}", "}"))
            if (open < 0) break
            if (text.startsWith("{{", open)) {
                found.add("{")
                at = open + 2
                continue
            }
            val close = text.indexOf('}', open)
            if (close < 0) throw Mistake("-o: a brace is not closed: $text; write {{ for a brace in a name")
            found.add(placeholder(text.substring(open + 1, close)))
            at = close + 1
        }
        return found
    }

    private fun placeholder(word: String): Placeholder = known[word.lowercase()] ?: throw Mistake(
        "-o: unknown placeholder {$word}${EditDistance.hint(word, known.keys)}; known are " +
            Placeholder.entries.joinToString { it.word } + ", and {{ for a brace",
    )

    companion object {
        private val known = Placeholder.entries.associateBy { it.name.lowercase() }

        /** Returns the template without placeholders whose only file is [name]. */
        fun of(name: String): String = name.replace("{", "{{").replace("}}", "}}}}")
    }
}
