package dev.lazyz.conformance

import java.util.Base64

/** A report as one page, pictures included, without scripts. */
internal class ReportHtml(private val report: ConformanceReport) {
    fun text(): String = buildString {
        val title = escaped("${report.strategy.id}: Lazy Z conformance")
        appendLine("<!DOCTYPE html>")
        appendLine("""<html lang="en"><head><meta charset="utf-8"><title>$title</title>""")
        appendLine("""<meta name="viewport" content="width=device-width, initial-scale=1">""")
        appendLine("<style>$STYLE</style></head><body>")
        appendLine("<h1>$title</h1>")
        val verdict = if (report.isConformant) "good" else "bad"
        appendLine("""<p class="$verdict">${escaped(ReportText(report).verdict())}</p>""")
        waivers()
        facts()
        failures()
        rules()
        distribution()
        appendLine("</body></html>")
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

    private fun StringBuilder.facts() {
        val strategy = report.strategy
        appendLine("<h2>What was run</h2>")
        table {
            row("strategy", "${strategy.id}, ${strategy.className}, version ${strategy.version}")
            row("capabilities", strategy.capabilities.joinToString { it.name }.ifEmpty { "none" })
            row("suite", report.suiteVersion)
            row("Java", "${report.jvm}; ${report.os}")
            row("seed", "${report.seed}")
            row("tries", "${ConformanceReport.plain(report.tries)} times the usual")
        }
    }

    private fun StringBuilder.failures() {
        val told = report.results.filter { it.outcome.isFailure || it.failure != null }
        if (told.isNotEmpty()) appendLine("<h2>Failures</h2>")
        for (result in told) {
            appendLine("""<h3 id="${result.rule.name}">${escaped(result.rule.name)}</h3>""")
            val note = "${result.outcome.words}, ${result.rule.level}. ${result.rule.intent}"
            appendLine("<p>${escaped(note)}</p>")
            if (result.rule.look.isNotEmpty()) appendLine("<p>Look at: ${escaped(result.rule.look)}</p>")
            val failure = result.failure
            if (failure == null || failure.message != result.message) appendLine("<p>${escaped(result.message)}</p>")
            if (failure != null) {
                pictures(failure)
                appendLine("<pre>${escaped(failure.message)}</pre>")
            }
            appendLine("<p>To see it again: <code>${escaped(report.commandFor(result.rule))}</code></p>")
        }
    }

    private fun StringBuilder.pictures(failure: RuleFailure) {
        val pictures = Pictures.of(failure)?.png() ?: return
        appendLine("<div>")
        for ((name, png) in pictures) {
            val data = Base64.getEncoder().encodeToString(png)
            append("""<figure><img alt="$name" src="data:image/png;base64,$data">""")
            appendLine("<figcaption>$name</figcaption></figure>")
        }
        appendLine("</div>")
    }

    private fun StringBuilder.rules() {
        appendLine("<h2>Rules</h2>")
        table("rule", "level", "outcome", "tries", "ms", "intent") {
            for (it in report.results) {
                val rule = it.rule
                row(rule.name, "${rule.level}", it.outcome.words, "${it.tries}", "${it.milliseconds}", rule.intent)
            }
        }
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
        const val STYLE =
            "body{font:16px/1.45 sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;" +
                "color:#222;background:#fff}" +
                "table{border-collapse:collapse}td,th{text-align:left;padding:.2rem .8rem .2rem 0;" +
                "border-bottom:1px solid #ddd;vertical-align:top}pre{background:#f4f4f4;padding:.8rem;overflow:auto}" +
                "figure{display:inline-block;margin:0 1rem 1rem 0}" +
                "img{border:1px solid #999;image-rendering:pixelated}" +
                ".good{color:#176117;font-weight:bold}.bad{color:#a01818;font-weight:bold}"
    }
}
