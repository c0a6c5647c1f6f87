package dev.lazyz.cli.conformance

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Streams
import dev.lazyz.conformance.RecordedReport
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.results.RuleListener
import java.util.Locale

/** What `zcli conformance` says of a report: that it compares with [recorded], if there is one. */
internal class ConformanceWords(private val recorded: RecordedReport?, private val isJson: Boolean) {
    /** What to print. */
    fun text(report: ConformanceReport): String =
        if (isJson) report.toJson() else recorded?.let { comparison(it, report) } ?: report.toText()

    private fun comparison(recorded: RecordedReport, report: ConformanceReport): String {
        val differences = recorded.differences(report)
        val rules = "${report.results.size} rules"
        if (differences.isEmpty()) return "verified: ${report.strategy.id}, $rules, the same outcomes\n"
        return "NOT verified: ${report.strategy.id}, ${differences.size} of $rules have another outcome\n" +
            differences.joinToString("") { "  $it\n" }
    }

    /** The exit code. */
    fun code(report: ConformanceReport): Int {
        val isGood = recorded?.let { it.differences(report).isEmpty() } ?: report.isConformant
        return if (isGood) ExitCode.DONE else ExitCode.DIFFERENT
    }

    companion object {
        private const val MILLISECONDS = 1000.0

        /** Columns of an outcome's words. */
        private const val OUTCOME = 13

        /** Says on standard error what came of each rule as soon as it is known. */
        fun told(streams: Streams): RuleListener = RuleListener { rule, outcome, milliseconds ->
            val words = "$outcome".lowercase().replace('_', ' ').padEnd(OUTCOME)
            streams.note("%s  %s  %.1f s\n".format(Locale.ROOT, words, rule, milliseconds / MILLISECONDS))
        }
    }
}
