package dev.lazyz.cli.report

import dev.lazyz.cli.output.StatisticsTable

/**
 * A number of a strategy in a report.
 *
 * @property title its name, which begins a sentence
 * @property meaning what it is, in one sentence
 * @property key its name in the statistics, or null if it is computed here
 * @property isCharted whether there is a chart of it
 */
internal enum class ReportMeasure(
    val title: String,
    val meaning: String,
    private val key: String?,
    val isCharted: Boolean = false,
) {
    SHADING_CALLS(
        "Shading calls",
        "How often a colour was computed, which is the expensive part if materials, textures and light are rich.",
        "shadingCalls",
        isCharted = true,
    ),
    DISCARDED(
        "Discarded calls",
        "Shading calls for nothing: a nearer surface hides the colour. They are counted if a sample is a pixel.",
        null,
    ),
    DEPTH_EVALUATIONS(
        "Depth evaluations",
        "How often the depth of a surface was computed at a sample, to compare it with that of others.",
        "depthEvaluations",
        isCharted = true,
    ),
    DEPTH_PASSES(
        "Depth passes",
        "How often such a comparison found a surface that was nearer than all before it.",
        "depthPasses",
    ),
    FRAGMENTS(
        "Fragments",
        "Covered samples that were looked at, counted for each surface; some strategies reject hidden surfaces " +
            "before that.",
        "fragments",
        isCharted = true,
    ),
    OVERDRAW("Overdraw", "Fragments divided by the samples of the picture.", "overdraw"),
    PEAK_BYTES(
        "Memory held",
        "The most memory that the strategy's own arrays took at one time, without scene and picture.",
        "peakBytes",
        isCharted = true,
    ),
    TIME(
        "Time",
        "Time of rendering divided by that of the fastest strategy here. Machines are noisy: only ratios within this " +
            "run mean something, and small differences do not.",
        null,
        isCharted = true,
    ),
    MILLIS(
        "Milliseconds",
        "The median of the repetitions, without reading and set-up; not for comparisons with other runs.",
        "millis",
    ),
    PEAK_SUSPENSIONS(
        "Waiting calls",
        "The most shading calls that were postponed at one time, to be made later or never.",
        "peakSuspensions",
        isCharted = true,
    ),
    SHADING_STARTS(
        "Shading starts",
        "Postponed calls that were evaluated at the sample itself, not by steps from the sample before.",
        "shadingStarts",
    ),
    SHADING_STEPS("Shading steps", "Steps from sample to sample; only with --coherence.", "shadingSteps"),
    LONGEST_CHAIN("Longest chain", "The most such steps before one shading call.", "longestChain"),
    ;

    /** Returns the number of [entry], or null if there is none. */
    fun value(report: Report, entry: ReportEntry): Number? {
        val rendered = entry.rendered ?: return null
        return when (this) {
            DISCARDED -> entry.portrait?.order?.discarded?.toLong()
            TIME -> rendered.nanoseconds.toDouble() / report.fastest
            else -> report.comparison.statistics(rendered)[key] as Number
        }
    }

    /** Returns the number of [entry] with its unit. */
    fun text(report: Report, entry: ReportEntry): String {
        val value = value(report, entry)
        return when {
            entry.rendered == null -> entry.obstacle
            value == null -> "not counted"
            this == TIME -> "%.2f ×".format(null, value)
            else -> StatisticsTable.readable(key.orEmpty(), value)
        }
    }
}
