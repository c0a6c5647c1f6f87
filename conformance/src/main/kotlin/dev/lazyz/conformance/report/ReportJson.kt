package dev.lazyz.conformance.report

import dev.lazyz.conformance.census.Distribution
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waiver
import dev.lazyz.conformance.rules.ConformanceVersions
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject

/** A report as JSON. The keys are an interface: keys may be added, but existing ones do not change. */
internal class ReportJson(private val report: ConformanceReport) {
    fun text(): String = format.encodeToString(JsonObject.serializer(), report()) + "\n"

    private fun report(): JsonObject = buildJsonObject {
        put("conformant", report.isConformant)
        put("inconclusive", report.isInconclusive)
        putJsonArray("diagnosis") {
            for (cause in report.diagnosis.causes) {
                addJsonObject {
                    put("rule", cause.rule.name)
                    put("why", cause.why)
                }
            }
        }
        put("suite", report.suiteVersion)
        put("contract", ConformanceVersions.CONTRACT)
        putJsonObject("strategy") {
            put("id", report.strategy.id)
            put("class", report.strategy.className)
            put("version", report.strategy.version)
        }
        put("jvm", report.jvm)
        put("os", report.os)
        put("seed", report.seed)
        put("tries", report.tries)
        putJsonArray("capabilities") { for (it in report.strategy.capabilities) add(it.name) }
        put("waivers", buildJsonArray { for (waiver in report.waivers) add(waiver(waiver)) })
        putJsonObject("outcomes") {
            for (outcome in RuleOutcome.entries) put(key(outcome), report.withOutcome(outcome).size)
        }
        put("milliseconds", report.milliseconds)
        put("distribution", distribution(report.distribution))
        put("rules", buildJsonArray { for (result in report.results) add(result(result)) })
    }

    private fun waiver(waiver: Waiver): JsonObject = buildJsonObject {
        put("rule", waiver.rule)
        put("reason", waiver.reason)
        put("link", waiver.link)
        put("expires", waiver.expires.toString())
    }

    private fun result(result: RuleResult): JsonObject = buildJsonObject {
        put("rule", result.rule.name)
        put("number", result.rule.number)
        put("level", result.rule.level.name)
        put("outcome", key(result.outcome))
        put("tries", result.tries)
        put("milliseconds", result.milliseconds)
        put("intent", result.rule.intent)
        put("look", result.look)
        if (result.message.isNotEmpty()) put("message", result.message)
        put("distribution", distribution(result.distribution))
        result.failure?.let { put("failure", failure(it, result.rule)) }
    }

    private fun failure(failure: RuleFailure, rule: SuiteRule): JsonObject = buildJsonObject {
        put("message", failure.message)
        failure.symptoms?.let { symptoms -> putJsonArray("symptoms") { for (it in symptoms) add(camelCase(it.name)) } }
        failure.sample?.let { sample ->
            putJsonObject("sample") {
                put("x", sample.x)
                put("y", sample.y)
                put("expected", sample.expected)
                put("actual", sample.actual)
                put("differing", sample.count)
            }
        }
        failure.code?.let { put("frame", it) }
        failure.sceneFile?.let { put("scene", it) }
        put("command", report.commandFor(rule))
    }

    private fun distribution(distribution: Distribution): JsonObject = buildJsonObject {
        put("frames", distribution.frames)
        for (trait in FrameTrait.entries) put(camelCase(trait.name), distribution.count(trait))
        put("unexamined", distribution.unexamined)
    }

    private fun JsonObjectBuilder.put(key: String, value: Double) =
        put(key, if (value % 1.0 == 0.0) JsonPrimitive(value.toLong()) else JsonPrimitive(value))

    companion object {
        private val format = Json { prettyPrint = true }

        /** Returns the key of an [outcome]. */
        fun key(outcome: RuleOutcome): String = camelCase(outcome.name)

        /** Converts `SEVERAL_VISIBLE` to `severalVisible`. */
        private fun camelCase(name: String): String {
            val words = name.lowercase().split('_')
            return words.first() + words.drop(1).joinToString("") { it.replaceFirstChar(Char::uppercase) }
        }
    }
}
