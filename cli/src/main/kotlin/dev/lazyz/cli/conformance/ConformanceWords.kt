package dev.lazyz.cli.conformance

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.counted
import dev.lazyz.conformance.RecordedReport
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import java.util.Locale

/** The text and exit code of `zcli conformance` for a report, compared with [recorded] unless that is null. */
internal class ConformanceWords(private val recorded: RecordedReport?, private val isJson: Boolean) {
    /** Returns the text to print. */
    fun text(report: ConformanceReport): String =
        if (isJson) report.toJson() else recorded?.let { comparison(it, report) } ?: report.toText()

    private fun comparison(recorded: RecordedReport, report: ConformanceReport): String {
        val differences = recorded.differences(report)
        val rules = counted(report.results.size.toLong(), "rule")
        val open = report.withOutcome(RuleOutcome.INCONCLUSIVE)
        if (differences.isEmpty() && open.isNotEmpty()) {
            return "inconclusive: ${report.strategy.id}, $rules, no different outcome\n" +
                open.joinToString("") { "  ${it.rule}: ${it.message.lineSequence().first()}\n" }
        }
        if (differences.isEmpty()) return "verified: ${report.strategy.id}, $rules, the same outcomes\n"
        return "NOT verified: ${report.strategy.id}, $rules, ${differences.size} with a different outcome\n" +
            differences.joinToString("") { "  $it\n" }
    }

    /** Returns the exit code. */
    fun code(report: ConformanceReport): Int {
        val isWrong =
            recorded?.let { it.differences(report).isNotEmpty() } ?: report.results.any { it.outcome.isFailure }
        return when {
            isWrong -> ExitCode.DIFFERENT
            report.withOutcome(RuleOutcome.INCONCLUSIVE).isNotEmpty() -> ExitCode.INCONCLUSIVE
            else -> ExitCode.DONE
        }
    }

    companion object {
        private const val MILLISECONDS = 1000.0

        /** Width of the column of outcomes. */
        private const val OUTCOME = 13

        /** Returns a listener that prints the outcome of each rule to standard error as soon as it is known. */
        fun progressListener(streams: Streams): RuleListener = RuleListener { rule, outcome, milliseconds ->
            val words = "$outcome".lowercase().replace('_', ' ').padEnd(OUTCOME)
            streams.note("%s  %s  %.1f s\n".format(Locale.ROOT, words, rule, milliseconds / MILLISECONDS))
        }
    }
}
