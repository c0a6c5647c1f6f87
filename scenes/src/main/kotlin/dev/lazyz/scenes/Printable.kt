package dev.lazyz.scenes

/**
 * Returns [text] in a form that is safe to print on a terminal: control characters, and characters that change the
 * direction of writing, become `?`, and words are cut after [LONGEST_WORD] characters.
 */
internal fun printable(text: String): String {
    val shown = StringBuilder(text.length)
    var word = 0
    for (character in text) {
        word = if (character == ' ') 0 else word + 1
        when {
            word == LONGEST_WORD + 1 -> shown.append("...")
            word > LONGEST_WORD -> Unit
            isHarmless(character) -> shown.append(character)
            else -> shown.append('?')
        }
    }
    return shown.toString()
}

/** In characters. Longer than any file name that operating systems allow. */
private const val LONGEST_WORD = 400

private fun isHarmless(character: Char): Boolean = when (character.category) {
    CharCategory.CONTROL, CharCategory.FORMAT, CharCategory.LINE_SEPARATOR, CharCategory.PARAGRAPH_SEPARATOR,
    CharCategory.PRIVATE_USE,
    -> false
    else -> true
}
