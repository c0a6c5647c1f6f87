package dev.lazyz.cli.report

import dev.lazyz.cli.page.BarChart
import dev.lazyz.scenes.html.Html.escaped

/** The counters and times of a [report], as charts and as a table. */
internal class ReportNumbers(private val report: Report) {
    /** Returns a chart for each number that is worth one; without those that are 0 for all. */
    fun charts(): String = buildString {
        appendLine("<p>Shorter bars are less work. Each chart has a scale of its own, which begins at 0; ")
        appendLine("""<a href="#numbers">the table</a> has the same numbers.</p>""")
        appendLine("""<div class="grid">""")
        for (measure in ReportMeasure.entries.filter { it.isCharted }) {
            val values = report.entries.mapNotNull { measure.value(report, it)?.toDouble() }
            if (values.any { it > 0 }) chart(measure)
        }
        appendLine("</div>")
    }

    private fun StringBuilder.chart(measure: ReportMeasure) {
        val hasParts = measure == ReportMeasure.SHADING_CALLS
        val bars = report.entries.map { entry ->
            val part = if (hasParts) ReportMeasure.DISCARDED.value(report, entry)?.toDouble() ?: 0.0 else 0.0
            val value = measure.value(report, entry)?.toDouble()
            BarChart.Bar(entry.id, value, measure.text(report, entry), part)
        }
        appendLine("""<figure class="card">""")
        appendLine("<h3>${measure.title}</h3>")
        append("<figcaption>${escaped(measure.meaning)}")
        if (bars.any { it.part > 0 }) {
            append(""" <span class="swatch" style="background:var(--discarded)"></span> discarded: a nearer surface """)
            append("hides the colour.")
        }
        appendLine("</figcaption>")
        append(BarChart(measure.title, bars, "discarded").svg())
        appendLine("</figure>")
    }

    /** Returns all numbers, and what they mean. */
    fun table(): String = buildString {
        appendLine("""<div class="scroll" role="region" tabindex="0" aria-label="Table of all numbers">""")
        appendLine("<table>")
        appendLine("<caption>Numbers of each strategy. The terms are explained below.</caption>")
        appendLine("""<thead><tr><th scope="col">Strategy</th><th scope="col">Picture</th>""")
        for (measure in ReportMeasure.entries) append("""<th scope="col">${measure.title}</th>""")
        appendLine("</tr></thead>")
        appendLine("<tbody>")
        for (entry in report.entries) row(entry)
        appendLine("</tbody></table></div>")
        appendLine("<dl>")
        for (measure in ReportMeasure.entries) {
            appendLine("<dt>${measure.title}</dt><dd>${escaped(measure.meaning)}</dd>")
        }
        appendLine("</dl>")
    }

    private fun StringBuilder.row(entry: ReportEntry) {
        append("""<tr><th scope="row">${escaped(entry.id)}</th><td>${badge(report, entry)}</td>""")
        if (entry.rendered == null) {
            append("""<td class="words" colspan="${ReportMeasure.entries.size}">no numbers</td>""")
        } else {
            for (measure in ReportMeasure.entries) append("<td>${escaped(measure.text(report, entry))}</td>")
        }
        appendLine("</tr>")
    }

    companion object {
        /** Returns the result of [entry] in one word. */
        fun badge(report: Report, entry: ReportEntry): String {
            val (look, word) = when {
                entry.rendered == null -> (if (entry.obstacle == "failed") "bad" else "none") to entry.obstacle
                report.isIdentical(entry) -> "good" to "identical"
                else -> "bad" to "different"
            }
            return """<span class="badge $look">$word</span>"""
        }
    }
}
