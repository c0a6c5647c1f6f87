package dev.lazyz.scenes.fuzz.mutations

import java.util.Random

/** Changes lines and words, byte by byte characters, so that text in no encoding survives too. */
internal object TextMutations : Mutations {
    private val token = Regex("""[A-Za-z_][\w.:-]*|[-+]?[0-9][\w.+-]*|[ \t]+|.""", RegexOption.DOT_MATCHES_ALL)

    private val odd = listOf(
        "\u0000", "\u001B[2J", "\t", "\r", "\n", "\r\n", "\\\n", "\"", "'", "#", "/", "//", "\\", "<", ">",
        "&", "&amp;",
        "\u00EF\u00BB\u00BF", "\u00C2\u0085", "\u00E2\u0080\u00AE", "\u00ED\u00A0\u0080", "\u00FF\u00FE",
        "[", "{", "]", ":",
    )

    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray {
        val text = mutate(String(input, Charsets.ISO_8859_1), String(other, Charsets.ISO_8859_1), random)
        return text.toByteArray(Charsets.ISO_8859_1)
    }

    fun mutate(text: String, other: String, random: Random): String =
        if (random.nextInt(3) == 0) {
            lines(text.split('\n').toMutableList(), other.split('\n'), random).joinToString("\n")
        } else {
            tokens(tokens(text), tokens(other), random).joinToString("")
        }

    private fun tokens(text: String): MutableList<String> = token.findAll(text).mapTo(ArrayList()) { it.value }

    private fun lines(lines: MutableList<String>, other: List<String>, random: Random): List<String> {
        val at = random.nextInt(lines.size)
        val count = 1 + random.small(lines.size - at)
        when (random.nextInt(5)) {
            0 -> lines.subList(at, at + count).clear()
            1 -> lines.addAll(random.nextInt(lines.size + 1), lines.subList(at, at + count).toList())
            2 -> lines.add(at, random.pick(other))
            3 -> lines.add(random.nextInt(lines.size), lines.removeAt(at))
            else -> repeat(random.small(MOST_COPIES)) { lines.add(at, lines[at]) }
        }
        return lines
    }

    private fun tokens(tokens: MutableList<String>, other: List<String>, random: Random): List<String> {
        if (tokens.isEmpty()) return listOf(random.pick(odd))
        val at = place(tokens, random)
        when (random.nextInt(9)) {
            0 -> tokens.removeAt(at)
            1 -> tokens.add(at, tokens[at] + " ")
            2 -> tokens[at] = random.pick(odd)
            3 -> tokens.add(at, random.pick(odd))
            4 -> tokens[at] = tokens[place(tokens, random)]
            5 -> tokens[at] = (tokens[at] + " ").repeat(1 + random.small(MOST_COPIES))
            else -> tokens[at] = like(tokens[at], other, random)
        }
        return tokens
    }

    /** Another token of the same sort: a number for a number, a word for a word. */
    private fun like(token: String, other: List<String>, random: Random): String {
        val isNumber = token.any { it.isDigit() }
        if (isNumber && random.nextBoolean()) return random.pick(InterestingNumbers.words)
        repeat(TRIES) {
            if (other.isEmpty()) return token
            val pick = other[place(other, random)]
            if (pick.any { it.isDigit() } == isNumber && pick[0].isLetter() == token[0].isLetter()) return pick
        }
        return random.pick(InterestingNumbers.words)
    }

    /** A place of a token that is not blank, if a few tries find one. */
    private fun place(tokens: List<String>, random: Random): Int {
        repeat(TRIES) {
            val at = random.nextInt(tokens.size)
            if (tokens[at].isNotBlank()) return at
        }
        return random.nextInt(tokens.size)
    }

    private const val MOST_COPIES = 300
    private const val TRIES = 4
}
