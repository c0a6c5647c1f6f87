package dev.lazyz.cli.page

import dev.lazyz.scenes.html.Html.escaped

/**
 * A chart of horizontal bars that begin at 0, as SVG. It is as wide as its place, and the text keeps its size.
 *
 * @param title what the bars show
 * @param partName what the last part of a bar shows, in the description
 */
internal class BarChart(private val title: String, private val bars: List<Bar>, private val partName: String = "") {
    /**
     * A bar.
     *
     * @property value its length, 0 or more, or null if there is none
     * @property text the value as text, or why there is none
     * @property part so much of [value] is drawn in another colour, at the end
     */
    class Bar(val label: String, val value: Double?, val text: String, val part: Double = 0.0)

    private val most = bars.mapNotNull { it.value }.maxOrNull()?.takeIf { it > 0 } ?: 1.0

    /** Returns the chart. All its numbers are in its description, too. */
    fun svg(): String = buildString {
        val height = bars.size * ROW
        append("""<svg class="bars" role="img" width="100%" height="$height" aria-label="${escaped(description())}">""")
        appendLine()
        for ((number, bar) in bars.withIndex()) append(bar, number * ROW)
        appendLine("</svg>")
    }

    private fun description(): String = bars.joinToString("; ", "$title: ") { bar ->
        val part = if (bar.part > 0) " ($partName ${percent(bar.part / checkNotNull(bar.value))})" else ""
        "${bar.label} ${bar.text}$part"
    }

    private fun StringBuilder.append(bar: Bar, top: Int) {
        appendLine("""<text x="0" y="${top + BASE_LINE}">${escaped(bar.label)}</text>""")
        appendLine("""<text class="value" x="100%" y="${top + BASE_LINE}">${escaped(bar.text)}</text>""")
        appendLine(rectangle("track", top, 0.0, 1.0))
        val value = bar.value ?: return
        appendLine(rectangle("bar", top, 0.0, (value - bar.part) / most))
        if (bar.part > 0) appendLine(rectangle("part", top, (value - bar.part) / most, bar.part / most))
    }

    private fun rectangle(look: String, top: Int, start: Double, length: Double): String =
        """<rect class="$look" x="${percent(start)}" y="${top + BAR_TOP}" width="${percent(length)}" """ +
            """height="$BAR_HEIGHT"/>"""

    private fun percent(part: Double): String = "%.2f%%".format(null, 100 * part)

    private companion object {
        const val ROW = 36
        const val BASE_LINE = 13
        const val BAR_TOP = 19
        const val BAR_HEIGHT = 8
    }
}
