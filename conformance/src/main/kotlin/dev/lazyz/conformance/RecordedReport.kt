package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.ReportJson
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waiver
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.conformance.results.reason
import dev.lazyz.conformance.rules.ConformanceVersions
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDate
import java.util.function.Supplier
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

/**
 * The contents of a `report.json` that are needed to repeat the run and compare the outcomes, so that a report can be
 * verified. Immutable and thread safe.
 *
 * @property strategy id of the renderer that was tested
 * @property seed seed of the frames
 * @property tries factor of the default number of frames
 * @property outcomes outcome of each rule by the rule's name: a key of the report's `outcomes`, such as `passed`
 */
public class RecordedReport private constructor(
    public val strategy: String,
    public val seed: Long,
    public val tries: Double,
    public val outcomes: Map<String, String>,
    private val waivers: Waivers,
) {
    /** Returns a run of the same rules with the same settings. */
    public fun again(renderer: Supplier<out Renderer>): Conformance {
        val conformance = Conformance(renderer).seed(seed).tries(tries).waivers(waivers)
        for (rule in outcomes.keys) conformance.rule(rule)
        return conformance
    }

    /**
     * Returns a line for each rule that has a different outcome in [report], ordered by number; empty if there is none.
     * A rule that is inconclusive in either has none: see [RuleOutcome.INCONCLUSIVE].
     */
    public fun differences(report: ConformanceReport): List<String> = report.results.mapNotNull { result ->
        val recorded = outcomes[result.rule.name]
        val actual = ReportJson.key(result.outcome)
        val isSame = recorded == actual || INCONCLUSIVE in setOf(recorded, actual)
        if (isSame) null else "${result.rule}: recorded ${recorded ?: "nothing"}, now $actual"
    }

    override fun toString(): String = "RecordedReport($strategy, seed $seed, tries $tries, ${outcomes.size} rules)"

    public companion object {
        private val INCONCLUSIVE = ReportJson.key(RuleOutcome.INCONCLUSIVE)

        /**
         * Reads the file at [path].
         *
         * @throws RecordedReportException if the file cannot be read, is not a report, or belongs to another version of
         *   the suite
         */
        @JvmStatic
        public fun read(path: Path): RecordedReport {
            val text = try {
                Files.readString(path)
            } catch (e: IOException) {
                throw RecordedReportException("the report $path cannot be read: ${reason(e)}", e)
            }
            return try {
                of(Json.parseToJsonElement(text).jsonObject, path)
            } catch (e: RecordedReportException) {
                throw e
            } catch (e: RuntimeException) {
                // Broken JSON, a missing key, or a value of another type
                throw RecordedReportException("$path is no report.json of the conformance suite", e)
            }
        }

        private fun of(json: JsonObject, path: Path): RecordedReport {
            val suite = json.text("suite")
            if (suite != ConformanceVersions.SUITE) {
                throw RecordedReportException(
                    "$path is for version $suite of the suite, but this is version ${ConformanceVersions.SUITE}: " +
                        "verify it with version $suite",
                )
            }
            val rules = json.getValue("rules").jsonArray.map { it.jsonObject }
            val outcomes = rules.associate { it.text("rule") to it.text("outcome") }
            val unknown = outcomes.keys.filter { SuiteRule.find(it) == null }
            if (unknown.isNotEmpty()) {
                throw RecordedReportException("$path has rules that are not in the suite: $unknown")
            }
            val waivers = json.getValue("waivers").jsonArray.map { waiver(it.jsonObject) }
            return RecordedReport(
                json.getValue("strategy").jsonObject.text("id"),
                json.text("seed").toLong(),
                json.text("tries").toDouble(),
                outcomes,
                Waivers.listed(waivers),
            )
        }

        private fun waiver(json: JsonObject): Waiver =
            Waiver(json.text("rule"), json.text("reason"), json.text("link"), LocalDate.parse(json.text("expires")))

        private fun JsonObject.text(key: String): String = getValue(key).jsonPrimitive.content
    }
}

/** Thrown if a file is not a report or belongs to another version of the suite. The message has the reason. */
public class RecordedReportException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)
