package dev.lazyz.cli.output

/**
 * Returns [number] with separators, and what it counts: [one] if the number is 1, otherwise [several]. `1 picture`,
 * `1,200 pictures`.
 */
internal fun counted(number: Long, one: String, several: String = "${one}s"): String =
    "%,d %s".format(null, number, if (number == 1L) one else several)

/** Returns [text] on one line, with `?` for control characters, which a terminal would execute. */
internal fun printable(text: String): String = text.map { if (it.isISOControl()) '?' else it }.joinToString("")
