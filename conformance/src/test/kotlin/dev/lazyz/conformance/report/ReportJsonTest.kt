package dev.lazyz.conformance.report

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.mutants.Promising
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.Waivers
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `report.json`: its keys are an interface, and each has the report's value. */
class ReportJsonTest {
    private val waiver =
        "rule: rule_7_3_rowsArriveInOrderEachOnce\nreason: <none>\nlink: https://example.org/7\nexpires: 9999-01-01\n"

    private val report = Conformance { WrongColors() }.tries(0.05).withoutShrinking().waivers(Waivers.parse(waiver))
        .rule("rule_5_1_nearestFragmentIsVisible").rule("8.2").rule("rule_7_3_rowsArriveInOrderEachOnce").run()

    private val json = Json.parseToJsonElement(report.toJson()).jsonObject

    private fun JsonObject.text(key: String): String = getValue(key).jsonPrimitive.content

    @Test
    fun runIsDescribed() {
        val strategy = json.getValue("strategy").jsonObject
        assertEquals(setOf("id", "class", "version"), strategy.keys)
        assertEquals("wrong-colors", strategy.text("id"))
        assertEquals(WrongColors::class.java.name, strategy.text("class"))
        assertEquals(report.strategy.version, strategy.text("version"))
        assertEquals(report.suiteVersion, json.text("suite"))
        assertEquals(report.jvm, json.text("jvm"))
        assertTrue(report.jvm.endsWith(", with the Vector API"), report.jvm)
        assertEquals(report.os, json.text("os"))
        assertEquals("0.05", json.text("tries"))
        assertEquals("${report.milliseconds}", json.text("milliseconds"))
        assertEquals(0, json.getValue("capabilities").jsonArray.size)
        val waived = json.getValue("waivers").jsonArray.single().jsonObject
        assertEquals(
            mapOf(
                "rule" to "rule_7_3_rowsArriveInOrderEachOnce",
                "reason" to "<none>",
                "link" to "https://example.org/7",
                "expires" to "9999-01-01",
            ),
            waived.mapValues { it.value.jsonPrimitive.content },
        )
    }

    @Test
    fun capabilitiesAreInTheirOrder() {
        val all = Conformance {
            Promising()
        }.rule("rule_4_3_backgroundIsVisibleWhereNoFragmentPasses").tries(0.01).run()
        val reported = Json.parseToJsonElement(all.toJson()).jsonObject.getValue("capabilities").jsonArray
        assertEquals(Promising().capabilities.sorted().map { it.name }, reported.map { it.jsonPrimitive.content })
    }

    @Test
    fun outcomesAreCounted() {
        val counts = json.getValue("outcomes").jsonObject.mapValues { it.value.jsonPrimitive.content }
        val expected = RuleOutcome.entries.associate { key(it) to "${report.withOutcome(it).size}" }
        assertEquals(expected, counts)
        assertEquals(listOf("1", "1"), listOf(counts["failed"], counts["waivedButPasses"]))
    }

    @Test
    fun ruleIsDescribed() {
        val rules = json.getValue("rules").jsonArray.map { it.jsonObject }
        for ((rule, result) in rules zip report.results) {
            assertEquals(result.rule.name, rule.text("rule"))
            assertEquals(result.rule.number, rule.text("number"))
            assertEquals("${result.rule.level}", rule.text("level"))
            assertEquals(key(result.outcome), rule.text("outcome"))
            assertEquals("${result.tries}", rule.text("tries"))
            assertEquals("${result.milliseconds}", rule.text("milliseconds"))
            assertEquals(result.rule.intent, rule.text("intent"))
            assertEquals(result.rule.look, rule.text("look"))
            assertEquals(result.message, rule["message"]?.jsonPrimitive?.content.orEmpty())
            assertEquals("${result.distribution.frames}", rule.getValue("distribution").jsonObject.text("frames"))
            assertEquals(result.failure != null, "failure" in rule)
        }
    }

    @Test
    fun failureIsDescribed() {
        val result = report.results.single { it.failure != null }
        val reported = json.getValue("rules").jsonArray.map { it.jsonObject }.single { "failure" in it }
        val failure = reported.getValue("failure").jsonObject
        val sample = checkNotNull(result.failure?.sample)
        assertTrue(sample.count > 1, "${sample.count}")
        assertEquals(result.failure.message, failure.text("message"))
        assertEquals(result.failure.code, failure.text("frame"))
        assertEquals(report.commandFor(result.rule), failure.text("command"))
        assertEquals(
            mapOf(
                "x" to "${sample.x}",
                "y" to "${sample.y}",
                "expected" to sample.expected,
                "actual" to sample.actual,
                "differing" to "${sample.count}",
            ),
            failure.getValue("sample").jsonObject.mapValues { it.value.jsonPrimitive.content },
        )
    }

    @Test
    fun traitsAreCounted() {
        val all = json.getValue("distribution").jsonObject.mapValues { it.value.jsonPrimitive.content.toLong() }
        val expected = FrameTrait.entries.map { report.distribution.count(it) }
        val (frames, unexamined) = report.distribution.let { it.frames to it.unexamined }
        assertEquals(listOf(frames) + expected + unexamined, all.values.toList())
        assertEquals(listOf("frames", "noPrimitives", "nothingVisible", "severalVisible"), all.keys.take(4))
        assertEquals("unexamined", all.keys.last())
    }

    @Test
    fun pageListsTheKeys() {
        val docs = listOf("docs", "../docs").map { Path.of(it) }.first { Files.isDirectory(it) }
        val section = docs.resolve("conformance.md").readText().substringAfter("key of `report.json`")
        val table = section.lines().takeWhile { it.startsWith("|") || "meaning" in it }.joinToString("\n")
        val listed = Regex("`([A-Za-z]+)`").findAll(table).map { it.groupValues[1] }.toSet()
        val traits = json.getValue("distribution").jsonObject.keys - "frames"
        val missing = keys(json) - traits - listed
        assertEquals(emptySet<String>(), missing, "keys of report.json that docs/conformance.md does not list")
        assertTrue(listed.size >= 40, "$listed")
    }

    private fun keys(element: JsonElement): Set<String> = when (element) {
        is JsonObject -> element.keys + element.values.flatMap { keys(it) }
        is JsonArray -> element.flatMap { keys(it) }.toSet()
        else -> emptySet()
    }

    /** `waived but passes` becomes `waivedButPasses`. */
    private fun key(outcome: RuleOutcome): String =
        outcome.words.split(' ').reduce { key, word -> key + word.replaceFirstChar { it.uppercase() } }
}
