package dev.lazyz.conformance.report

import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.results.Diagnosis
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.counted
import dev.lazyz.conformance.rules.ConformanceVersions
import java.util.Locale

/** A report for a terminal. If it [isOnDisk], files of failures are next to it. */
internal class ReportText(private val report: ConformanceReport, private val isOnDisk: Boolean = false) {
    fun text(): String = buildString {
        appendLine(verdict())
        diagnosis()
        appendLine()
        heading()
        waivers()
        for (result in report.detailed.take(MOST_DETAILED)) failure(result)
        appendLine()
        rules()
        appendLine()
        distribution()
        appendLine()
        appendLine(verdict())
    }

    /** The last line: whether the renderer conforms, if that is known, and the number of rules per outcome. */
    fun verdict(): String {
        val counts = RuleOutcome.entries.associateWith { report.withOutcome(it).size }.filterValues { it > 0 }
        val verdict = when {
            report.isConformant -> "conforms"
            report.isInconclusive -> "may conform, this run is inconclusive"
            else -> "does NOT conform"
        }
        val numbers = counts.entries.joinToString { (outcome, count) -> "$count ${outcome.words}" }
        return "${report.strategy.id} $verdict: ${counted(report.results.size.toLong(), "rule")}, $numbers; " +
            "%.1f s".format(Locale.ROOT, report.milliseconds / 1000.0)
    }

    private fun StringBuilder.diagnosis() {
        val causes = report.diagnosis.causes
        if (causes.isEmpty()) return
        appendLine()
        appendLine(if (causes.size == 1) "Likely cause" else "Likely causes, best first")
        for ((i, cause) in causes.withIndex()) {
            appendLine("  ${i + 1}. ${cause.rule}: ${cause.why}")
            appendLine("     ${cause.look}")
        }
    }

    private fun StringBuilder.heading() {
        val strategy = report.strategy
        val capabilities = strategy.capabilities.joinToString { it.name }.ifEmpty { "none" }
        appendLine("Lazy Z conformance suite ${report.suiteVersion}, contract ${ConformanceVersions.CONTRACT}")
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
        message(result.message, result.rule)
        val failure = result.failure
        if (failure != null && failure.message != result.message) message(failure.message, result.rule)
        appendLine("  why         ${result.rule.intent}")
        appendLine("  look at     ${result.look}")
        if (failure?.code != null) appendLine("  scene file  ${sceneFile(failure, result.rule)}")
        appendLine("  reproduce   ${report.commandFor(result.rule)}")
    }

    /** Appends [message], shortened if it is long. */
    private fun StringBuilder.message(message: String, rule: SuiteRule) {
        val lines = message.lines()
        for (line in lines.take(MOST_LINES)) appendLine("    ${shortened(line)}")
        val rest = lines.size - MOST_LINES
        if (rest > 0) {
            val place = if (isOnDisk) "; see failures/$rule.kt" else ""
            appendLine("    (${counted(rest.toLong(), "more line")}$place)")
        }
    }

    private fun shortened(line: String): String =
        if (line.length > MOST_COLUMNS) "${line.take(MOST_COLUMNS)} ..." else line

    private fun sceneFile(failure: RuleFailure, rule: SuiteRule): String = when {
        failure.sceneFile == null -> NO_SCENE_FILE
        isOnDisk -> "failures/$rule.json"
        else -> "written with a report (zcli: --report FOLDER)"
    }

    private fun StringBuilder.rules() {
        val words = report.results.maxOfOrNull { it.outcome.words.length } ?: 0
        val names = report.results.maxOfOrNull { it.rule.name.length } ?: 0
        for (result in report.results) {
            val note = note(result)
            appendLine(
                "${result.outcome.words.padEnd(words)}  ${result.rule.name.padEnd(names)}  " +
                    "${"${result.tries}".padStart(6)} tries ${"${result.milliseconds}".padStart(6)} ms$note",
            )
        }
    }

    /** Returns the remark in the line of a rule that is not described in detail elsewhere. */
    private fun note(result: RuleResult): String {
        val isDetailed = result.outcome.isDetailed && result !in report.detailed.take(MOST_DETAILED)
        val isShort = result.outcome == RuleOutcome.NOT_SUPPORTED || result.outcome == RuleOutcome.PASSED
        if ((!isDetailed && !isShort) || result.message.isEmpty()) return ""
        return "  " + result.message.lineSequence().first().removePrefix("${report.strategy.id}: ").take(MOST_COLUMNS)
    }

    private fun StringBuilder.distribution() {
        val all = report.distribution
        appendLine("${counted(all.frames, "frame")}, of which")
        for (trait in FrameTrait.entries) appendLine("${"${all.count(trait)}".padStart(8)}  ${trait.words}")
        if (all.unexamined > 0) appendLine("${"${all.unexamined}".padStart(8)}  not looked at")
    }

    companion object {
        /** Number of failures that are described in detail; the others get one line. */
        private const val MOST_DETAILED = Diagnosis.MOST_CAUSES

        /** Greatest number of lines and columns of a failure's message. */
        private const val MOST_LINES = 20
        private const val MOST_COLUMNS = 200

        /** Why there is no scene file. */
        const val NO_SCENE_FILE: String = "none: a scene file cannot express this frame, but the code makes it"
    }
}
