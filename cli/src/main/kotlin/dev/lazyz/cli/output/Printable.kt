package dev.lazyz.cli.output

/** Returns [text] on one line, with `?` for control characters, which a terminal would execute. */
internal fun printable(text: String): String = text.map { if (it.isISOControl()) '?' else it }.joinToString("")
