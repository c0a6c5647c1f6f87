package dev.lazyz.cli.input

/** Returns the decimal number that [text] is, such as `-2.5` or `.5e3`, or null: other forms do not count. */
internal fun decimal(text: String): Double? =
    if (text.all { it in "0123456789.+-eE" }) text.toDoubleOrNull() else null
