package dev.lazyz.conformance.report

import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.rules.ConformanceVersions
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped

/** A report as one HTML page, including pictures, without scripts. */
internal class ReportHtml(private val report: ConformanceReport) {
    fun text(): String = buildString {
        val title = escaped("${report.strategy.id}: Lazy Z conformance")
        appendLine("<!DOCTYPE html>")
        appendLine("""<html lang="en"><head><meta charset="utf-8"><title>$title</title>""")
        appendLine("""<meta name="viewport" content="width=device-width, initial-scale=1">""")
        appendLine("<style>$STYLE</style></head><body>")
        appendLine("<h1>$title</h1>")
        val verdict = when {
            report.isConformant -> "good"
            report.isInconclusive -> "note"
            else -> "bad"
        }
        appendLine("""<p class="$verdict">${escaped(ReportText(report).verdict())}</p>""")
        diagnosis()
        waivers()
        failures("Failures") { it.isFailure || it == RuleOutcome.WAIVED }
        failures("Inconclusive") { it == RuleOutcome.INCONCLUSIVE }
        failures("Not followed") { it == RuleOutcome.NOT_FOLLOWED }
        facts()
        rules()
        distribution()
        appendLine("</body></html>")
    }

    private fun StringBuilder.diagnosis() {
        val causes = report.diagnosis.causes
        if (causes.isEmpty()) return
        appendLine("<h2>Likely ${if (causes.size == 1) "cause" else "causes, best first"}</h2>")
        appendLine("<ol>")
        for (cause in causes) {
            val link = """<a href="#${cause.rule.name}">${escaped(cause.rule.name)}</a>"""
            appendLine("<li>$link: ${escaped(cause.why)}<br>${escaped(cause.look)}</li>")
        }
        appendLine("</ol>")
    }

    private fun StringBuilder.waivers() {
        if (report.waivers.isEmpty()) return
        appendLine("<h2>Waivers</h2>")
        table("rule", "outcome", "reason", "link", "expires") {
            for (waiver in report.waivers) {
                val outcome = report.results.firstOrNull { it.rule.name == waiver.rule }?.outcome?.words ?: "not run"
                row(waiver.rule, outcome, waiver.reason, waiver.link, waiver.expires.toString())
            }
        }
    }

    private fun StringBuilder.failures(title: String, isMeant: (RuleOutcome) -> Boolean) {
        val detailed = (report.detailed + report.withOutcome(RuleOutcome.WAIVED)).filter { isMeant(it.outcome) }
            .sortedBy { !it.outcome.isFailure }
        if (detailed.isEmpty()) return
        appendLine("<h2>$title</h2>")

        // A table of contents, if there is more than one
        if (detailed.size > 1) {
            appendLine("<ul>")
            for (result in detailed) appendLine("<li>${link(result)} ${badge(result)}</li>")
            appendLine("</ul>")
        }
        for (result in detailed) failure(result)
    }

    private fun StringBuilder.failure(result: RuleResult) {
        val rule = result.rule
        appendLine("<section>")
        appendLine("""<h3 id="${rule.name}">${escaped(rule.name)} ${badge(result)}</h3>""")
        val failure = result.failure
        if (failure == null || failure.message != result.message) appendLine("<p>${escaped(result.message)}</p>")
        if (failure != null) {
            pictures(failure)
            appendLine("<pre>${escaped(failure.message)}</pre>")
        }
        appendLine("<dl>")
        entry("Why (${rule.level})", escaped(rule.intent))
        entry("Look at", escaped(result.look))
        entry("Reproduce with", "<code>${escaped(report.commandFor(rule))}</code>")
        appendLine("</dl>")
        appendLine("</section>")
    }

    private fun StringBuilder.entry(term: String, markup: String) {
        appendLine("<dt>$term</dt><dd>$markup</dd>")
    }

    private fun StringBuilder.pictures(failure: RuleFailure) {
        val pictures = Pictures.of(failure)?.png() ?: return
        appendLine("<div>")
        for ((name, png) in pictures) {
            append("""<figure><img alt="$name" src="${Html.pngUri(png)}">""")
            appendLine("<figcaption>$name</figcaption></figure>")
        }
        appendLine("</div>")
        if ("difference" in pictures) {
            appendLine("""<p class="note">Red: the colour differs; blue: only depth or primitive does.</p>""")
        }
    }

    private fun StringBuilder.facts() {
        val strategy = report.strategy
        appendLine("<h2>What was run</h2>")
        table {
            row("strategy", "${strategy.id}, ${strategy.className}, version ${strategy.version}")
            row("capabilities", strategy.capabilities.joinToString { it.name }.ifEmpty { "none" })
            row("suite", "${report.suiteVersion}, for contract ${ConformanceVersions.CONTRACT}")
            row("Java", "${report.jvm}; ${report.os}")
            row("seed", "${report.seed}")
            row("tries", "${ConformanceReport.plain(report.tries)} times the usual")
        }
    }

    private fun StringBuilder.rules() {
        appendLine("<h2>Rules</h2>")
        table("rule", "level", "outcome", "tries", "ms", "intent") {
            for (it in report.results) {
                val name = if (isDetailed(it)) link(it) else escaped(it.rule.name)
                val numbers = """<td class="number">${it.tries}</td><td class="number">${it.milliseconds}</td>"""
                appendLine(
                    "<tr><td>$name</td><td>${it.rule.level}</td><td>${badge(it)}</td>$numbers" +
                        "<td>${escaped(it.rule.intent)}</td></tr>",
                )
            }
        }
    }

    /** Whether the page has a section about the rule. */
    private fun isDetailed(result: RuleResult): Boolean = result.outcome.isDetailed || result.failure != null

    private fun link(result: RuleResult): String =
        """<a href="#${result.rule.name}">${escaped(result.rule.name)}</a>"""

    private fun badge(result: RuleResult): String {
        val look = when {
            result.outcome.isFailure -> "bad"
            result.outcome == RuleOutcome.PASSED -> "good"
            else -> "note"
        }
        return """<span class="$look">${escaped(result.outcome.words)}</span>"""
    }

    private fun StringBuilder.distribution() {
        val all = report.distribution
        appendLine("<h2>Frames</h2>")
        table("frames", "number") {
            row("all", "${all.frames}")
            for (trait in FrameTrait.entries) row(trait.words, "${all.count(trait)}")
            row("not looked at", "${all.unexamined}")
        }
    }

    private fun StringBuilder.table(vararg heads: String, rows: StringBuilder.() -> Unit) {
        appendLine("<table>")
        if (heads.isNotEmpty()) appendLine("<tr>${heads.joinToString("") { "<th>$it</th>" }}</tr>")
        rows()
        appendLine("</table>")
    }

    private fun StringBuilder.row(vararg cells: String) {
        appendLine("<tr>${cells.joinToString("") { "<td>${escaped(it)}</td>" }}</tr>")
    }

    private companion object {
        val STYLE = """
            body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem;
                color: #222; background: #fff }
            h2 { margin-top: 2.5rem } h3 { margin: 0; overflow-wrap: anywhere }
            section { margin: 1.5rem 0; padding: 1rem 1.2rem; border: 1px solid #ccc; border-radius: 6px }
            table { border-collapse: collapse } th { white-space: nowrap }
            td, th { text-align: left; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid #ddd;
                vertical-align: top }
            .number { text-align: right; font-variant-numeric: tabular-nums }
            pre, code { font: 14px/1.45 ui-monospace, monospace }
            pre { background: #f4f4f4; padding: .8rem; overflow: auto } code { overflow-wrap: anywhere }
            dl { margin: 0 } dt { font-weight: bold } dd { margin: 0 0 .5rem }
            figure { display: inline-block; margin: .8rem 1rem 0 0; vertical-align: top }
            figcaption { color: #555 }
            img { display: block; border: 1px solid #999; image-rendering: pixelated;
                background: conic-gradient(#ccc 25%, #fff 0 50%, #ccc 0 75%, #fff 0) 0 0 / 20px 20px }
            .good { color: #176117; font-weight: bold } .bad { color: #a01818; font-weight: bold }
            .note { color: #555 } h3 span, li span { font-size: 1rem; margin-left: .5rem }
        """.trimIndent()
    }
}
