package dev.lazyz.conformance.report

import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.rules.ConformanceVersions
import dev.lazyz.scenes.html.Html.escaped
import java.util.Locale

/** A report as the XML that build servers read: a test suite with a test case for each rule. */
internal class ReportJUnit(private val report: ConformanceReport) {
    fun text(): String = buildString {
        val failures = report.results.count { it.outcome.isFailure }
        val errors = report.withOutcome(RuleOutcome.INCONCLUSIVE).size
        val skipped = report.results.count { isSkipped(it) }
        appendLine("""<?xml version="1.0" encoding="UTF-8"?>""")
        appendLine(
            """<testsuite name="${suite()}" tests="${report.results.size}" failures="$failures" errors="$errors" """ +
                """skipped="$skipped" time="${seconds(report.milliseconds)}">""",
        )
        properties()
        for (result in report.results) case(result)
        appendLine("</testsuite>")
    }

    private fun suite() = escaped("dev.lazyz.conformance.${report.strategy.id}")

    private fun StringBuilder.properties() {
        val causes = report.diagnosis.causes.withIndex().associate { (i, it) -> "likely.cause.${i + 1}" to "$it" }
        val properties = mapOf("verdict" to ReportText(report).verdict()) + causes + mapOf(
            "suite.version" to report.suiteVersion,
            "contract.version" to ConformanceVersions.CONTRACT,
            "strategy.class" to report.strategy.className,
            "strategy.version" to report.strategy.version,
            "capabilities" to report.strategy.capabilities.joinToString(",") { it.name },
            "java" to report.jvm,
            "os" to report.os,
            "seed" to "${report.seed}",
            "tries" to ConformanceReport.plain(report.tries),
        )
        appendLine("  <properties>")
        for ((name, value) in properties) appendLine("""    <property name="$name" value="${escaped(value)}"/>""")
        appendLine("  </properties>")
    }

    private fun StringBuilder.case(result: RuleResult) {
        append("""  <testcase classname="${suite()}" name="${escaped(result.rule.name)}" """)
        append("""time="${seconds(result.milliseconds)}"""")
        when {
            result.outcome.isFailure || result.outcome == RuleOutcome.INCONCLUSIVE -> {
                val element = if (result.outcome.isFailure) "failure" else "error"
                appendLine(">")
                append("""    <$element type="${result.outcome.words}" """)
                append("""message="${escaped(result.message.lineSequence().first())}">""")
                appendLine("${escaped(details(result))}</$element>")
                appendLine("  </testcase>")
            }

            isSkipped(result) -> {
                appendLine(">")
                appendLine("""    <skipped message="${escaped(skipped(result))}"/>""")
                appendLine("  </testcase>")
            }

            else -> appendLine("/>")
        }
    }

    private fun skipped(result: RuleResult): String =
        if (result.outcome == RuleOutcome.NOT_FOLLOWED) "not followed: ${details(result)}" else result.message

    private fun details(result: RuleResult): String = listOfNotNull(
        result.message,
        result.failure?.message?.takeIf { it != result.message },
        result.rule.intent.takeIf { it.isNotEmpty() }?.let { "why: $it" },
        result.look.takeIf { it.isNotEmpty() }?.let { "look at: $it" },
        "reproduce: ${report.commandFor(result.rule)}",
    ).joinToString("\n")

    /** Neither passed nor failed, for a known reason. */
    private fun isSkipped(result: RuleResult): Boolean = !result.outcome.isFailure &&
        result.outcome != RuleOutcome.PASSED && result.outcome != RuleOutcome.INCONCLUSIVE

    private fun seconds(milliseconds: Long): String = "%.3f".format(Locale.ROOT, milliseconds / 1000.0)
}
