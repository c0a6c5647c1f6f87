package dev.lazyz.conformance

import java.util.Locale

/** A report for a terminal. */
internal class ReportText(private val report: ConformanceReport) {
    fun text(): String = buildString {
        heading()
        waivers()
        for (result in report.results.filter { it.outcome.isTold }) failure(result)
        appendLine()
        rules()
        appendLine()
        distribution()
        appendLine()
        appendLine(verdict())
    }

    /** The last line: numbers of outcomes, and what follows from them. */
    fun verdict(): String {
        val counts = RuleOutcome.entries.associateWith { report.withOutcome(it).size }.filterValues { it > 0 }
        val verdict = if (report.isConformant) "conforms" else "does NOT conform"
        val numbers = counts.entries.joinToString { (outcome, count) -> "$count ${outcome.words}" }
        return "${report.strategy.id} $verdict: ${counted(report.results.size.toLong(), "rule")}, $numbers; " +
            "%.1f s".format(Locale.ROOT, report.milliseconds / 1000.0)
    }

    private fun StringBuilder.heading() {
        val strategy = report.strategy
        val capabilities = strategy.capabilities.joinToString { it.name }.ifEmpty { "none" }
        appendLine("Lazy Z conformance suite ${report.suiteVersion}")
        appendLine("strategy      ${strategy.id} (${strategy.className}, version ${strategy.version})")
        appendLine("capabilities  $capabilities")
        appendLine("Java          ${report.jvm}; ${report.os}")
        appendLine("seed          ${report.seed}, tries x${ConformanceReport.plain(report.tries)}")
    }

    private fun StringBuilder.waivers() {
        if (report.waivers.isEmpty()) return
        appendLine()
        appendLine("Waivers")
        for (waiver in report.waivers) {
            val outcome = report.results.firstOrNull { it.rule.name == waiver.rule }?.outcome?.words ?: "not run"
            appendLine("  ${waiver.rule} ($outcome)")
            appendLine("    until ${waiver.expires}: ${waiver.reason}")
            appendLine("    ${waiver.link}")
        }
    }

    private fun StringBuilder.failure(result: RuleResult) {
        appendLine()
        appendLine("${result.outcome.words.uppercase()}: ${result.rule} (${result.rule.level})")
        appendLine(result.message.prependIndent("    "))
        val failure = result.failure
        if (failure != null && failure.message != result.message) appendLine(failure.message.prependIndent("    "))
        if (result.rule.intent.isNotEmpty()) appendLine("  why         ${result.rule.intent}")
        if (result.rule.look.isNotEmpty()) appendLine("  look at     ${result.rule.look}")
        if (failure?.code != null) appendLine("  scene file  ${sceneFile(failure, result.rule)}")
        appendLine("  reproduce   ${report.commandFor(result.rule)}")
    }

    private fun sceneFile(failure: RuleFailure, rule: SuiteRule): String =
        if (failure.sceneFile == null) NO_SCENE_FILE else "failures/$rule.json, where the report is on disk"

    private fun StringBuilder.rules() {
        val words = report.results.maxOfOrNull { it.outcome.words.length } ?: 0
        val names = report.results.maxOfOrNull { it.rule.name.length } ?: 0
        for (result in report.results) {
            val note = if (result.outcome == RuleOutcome.NOT_SUPPORTED) "  ${result.message}" else ""
            appendLine(
                "${result.outcome.words.padEnd(words)}  ${result.rule.name.padEnd(names)}  " +
                    "${"${result.tries}".padStart(6)} tries ${"${result.milliseconds}".padStart(6)} ms$note",
            )
        }
    }

    private fun StringBuilder.distribution() {
        val all = report.distribution
        appendLine("${counted(all.frames, "frame")}, of which")
        for (trait in FrameTrait.entries) appendLine("${"${all.count(trait)}".padStart(8)}  ${trait.words}")
        if (all.unexamined > 0) appendLine("${"${all.unexamined}".padStart(8)}  not looked at")
    }
    private fun counted(number: Long, thing: String): String = if (number == 1L) "1 $thing" else "$number ${thing}s"

    companion object {
        /** Why there is none. */
        const val NO_SCENE_FILE: String = "none: a scene file has no words for all that is in the frame"
    }
}
