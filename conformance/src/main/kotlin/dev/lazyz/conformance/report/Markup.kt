package dev.lazyz.conformance.report

/**
 * Returns [text] escaped as content or attribute value of XML and HTML. Characters that XML does not allow become
 * `U+FFFD`.
 */
internal fun escaped(text: String): String = buildString {
    for (point in text.codePoints()) {
        when (point) {
            '&'.code -> append("&amp;")
            '<'.code -> append("&lt;")
            '>'.code -> append("&gt;")
            '"'.code -> append("&quot;")
            '\''.code -> append("&#39;")
            '\n'.code, '\t'.code -> appendCodePoint(point)
            else -> appendCodePoint(if (isXml(point)) point else 0xFFFD)
        }
    }
}

private fun isXml(point: Int): Boolean =
    point in 0x20..0xD7FF || point in 0xE000..0xFFFD || point in 0x10000..0x10FFFF
