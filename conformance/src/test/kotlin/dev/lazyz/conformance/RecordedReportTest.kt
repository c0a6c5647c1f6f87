package dev.lazyz.conformance

import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.conformance.rules.ConformanceVersions
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** A recorded report is verified by another run. */
class RecordedReportTest {
    @TempDir
    lateinit var folder: Path

    private val waivers = Waivers.parse("rule: ${RuleNames.ties}\nreason: a\nlink: b\nexpires: 9999-01-01\n")

    private fun recorded(vararg rules: String): Path {
        val suite = Conformance { BasicMistakes.lastWinsTies() }.seed(3).tries(0.2).waivers(waivers).output(folder)
        for (rule in rules) suite.rule(rule)
        suite.run()
        return folder.resolve("report.json")
    }

    private fun message(path: Path) =
        assertThrows(RecordedReportException::class.java) { RecordedReport.read(path) }.message.orEmpty()

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun otherOutcomesAreReported() {
        val recorded = RecordedReport.read(recorded(RuleNames.ties))
        val differences = recorded.differences(recorded.again { PlainRenderer() }.run())
        assertTrue("${RuleNames.ties}: recorded waived, now waivedButPasses" in differences, "$differences")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatIsNoReportOrOfAnotherVersionIsAMistake() {
        val path = recorded(RuleNames.ties)
        val text = path.readText()
        path.writeText(text.replace("\"suite\": \"${ConformanceVersions.SUITE}\"", "\"suite\": \"0.0\""))
        assertTrue("is for version 0.0 of the suite, but this is version ${ConformanceVersions.SUITE}" in message(path))
        path.writeText(text.replace(RuleNames.ties, "rule_5_2_unheardOf"))
        assertTrue("rules that are not in the suite: [rule_5_2_unheardOf]" in message(path), message(path))
        for (other in listOf("", "[]", "{}", "{\"suite\": {}}", text.take(300))) {
            path.writeText(other)
            assertTrue("is no report.json of the conformance suite" in message(path), message(path))
        }
        assertTrue("cannot be read" in message(folder.resolve("none.json")))
    }
}
