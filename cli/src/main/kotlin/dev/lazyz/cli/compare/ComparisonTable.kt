package dev.lazyz.cli.compare

import com.github.ajalt.mordant.rendering.TextAlign
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.SectionBuilder
import dev.lazyz.cli.output.PlainTable
import dev.lazyz.cli.output.StatisticsTable

/** Formats a [Comparison] as a table with a row for each strategy, followed by the differences. */
internal object ComparisonTable {
    private val numbers = mapOf(
        "shadingCalls" to "shading calls",
        "depthEvaluations" to "depth evaluations",
        "overdraw" to "overdraw",
        "peakBytes" to "working memory",
        "millis" to "ms",
    )

    fun of(comparison: Comparison): String = table(comparison) + differences(comparison)

    private fun table(comparison: Comparison): String = PlainTable.of {
        for (column in numbers.keys.indices) column(2 + column) { align = TextAlign.RIGHT }
        header {
            cellBorders = Borders.ALL
            rowFrom(listOf("strategy", "identical") + numbers.values)
        }
        body {
            for ((id, outcome) in comparison.outcomes) {
                when (outcome) {
                    is Outcome.Rendered ->
                        rowFrom(listOf(id, verdict(id, outcome, comparison)) + values(outcome, comparison))
                    is Outcome.Failed -> textRow(id, "failed: ${outcome.message}")
                    is Outcome.NotBlending -> textRow(id, "does not blend")
                }
            }
        }
    }

    /** Adds a row without numbers. Its text spans the columns of the numbers. */
    private fun SectionBuilder.textRow(id: String, words: String) = row {
        cell(id)
        cell(words) {
            columnSpan = 1 + numbers.size
            align = TextAlign.LEFT
        }
    }

    private fun verdict(id: String, outcome: Outcome.Rendered, comparison: Comparison): String = when {
        outcome.difference != null -> "no"
        id == comparison.reference?.id -> "(reference)"
        else -> "yes"
    }

    private fun values(outcome: Outcome.Rendered, comparison: Comparison): List<String> {
        val statistics = comparison.statistics(outcome)
        return numbers.keys.map { StatisticsTable.readable(it, statistics.getValue(it)) }
    }

    private fun differences(comparison: Comparison): String = buildString {
        val reference = comparison.reference ?: return@buildString
        for ((id, outcome) in comparison.outcomes) {
            val difference = (outcome as? Outcome.Rendered)?.difference ?: continue
            val width = maxOf(id.length, reference.id.length)
            appendLine()
            appendLine(comparison.sentence(id, difference) + ":")
            appendLine("  ${reference.id.padEnd(width)}  ${difference.expected}")
            appendLine("  ${id.padEnd(width)}  ${difference.actual}")
        }
    }
}
