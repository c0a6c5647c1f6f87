package dev.lazyz.conformance.report

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.Promising
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.results.Waivers
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.createDirectories
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.w3c.dom.Element

/** How the summary, the XML for build servers and the files of a report show each outcome. */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class ReportLinesTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"
    private val rows = "rule_7_3_rowsArriveInOrderEachOnce"
    private val background = "rule_4_3_backgroundIsVisibleWhereNoFragmentPasses"
    private val unrun = "rule_9_6_narrowRastersAreDrawnCorrectly"

    private fun waiver(rule: String, expires: String = "9999-01-01") =
        "rule: $rule\nreason: <none>\nlink: https://example.org/7\nexpires: $expires\n\n"

    /** One rule each: failed, not supported, waived but passes, waived, and a waived one that is not run. */
    private val report = Conformance {
        WrongColors()
    }.tries(0.05).rule(nearest).rule(promise).rule(rows).rule(background)
        .waivers(Waivers.parse(waiver(background) + waiver(rows) + waiver(unrun))).run()

    private fun result(rule: String) = report.results.single { it.rule.name == rule }

    private fun suite(report: ConformanceReport): Element = DocumentBuilderFactory.newInstance().newDocumentBuilder()
        .parse(ByteArrayInputStream(report.toJUnitXml().toByteArray())).documentElement

    private fun Element.elements(name: String): List<Element> =
        getElementsByTagName(name).let { list -> List(list.length) { list.item(it) as Element } }

    @Test
    fun buildServersLearnHowManyFailedAndWhy() {
        val suite = suite(report)
        val counts = listOf("tests", "failures", "errors", "skipped").map { suite.getAttribute(it) }
        assertEquals(listOf("4", "2", "0", "2"), counts)
        assertEquals(report.milliseconds / 1000.0, suite.getAttribute("time").toDouble())
        val cases = suite.elements("testcase").associateBy { it.getAttribute("name") }
        assertEquals(report.results.map { it.rule.name }, cases.keys.toList())
        assertEquals(setOf(nearest, rows), cases.filterValues { it.elements("failure").size == 1 }.keys)
        val reasons = cases.mapValues { it.value.elements("skipped").singleOrNull()?.getAttribute("message") }
        assertEquals("SHADES_ONLY_VISIBLE is not declared", reasons[promise])
        assertEquals("waived until 9999-01-01: <none> (https://example.org/7)", reasons[background])
        val failure = cases.getValue(nearest).elements("failure").single().textContent
        assertTrue("\nwhy: ${result(nearest).rule.intent}\n" in failure, failure)
        assertTrue("\nlook at: ${result(nearest).rule.look}\n" in failure, failure)
        assertTrue("\nreproduce: ${report.commandFor(result(nearest).rule)}" in failure, failure)
    }

    @Test
    fun buildServersLearnWhatWasRun() {
        val odd = Conformance { PlainRenderer("<&\">") }.tries(0.05).rule(nearest).seed(7).run()
        assertEquals("dev.lazyz.conformance.<&\">", suite(odd).getAttribute("name"))
        val properties = suite(odd).elements("property").associate {
            it.getAttribute("name") to it.getAttribute("value")
        }
        assertEquals("7", properties["seed"])
        assertEquals("0.05", properties["tries"])
        assertEquals(odd.jvm, properties["java"])
        assertEquals(PlainRenderer::class.java.name, properties["strategy.class"])
        val promising = Conformance { Promising() }.tries(0.05).rule(nearest).run()
        val capabilities = suite(promising).elements("property").single { it.getAttribute("name") == "capabilities" }
        assertEquals(promising.strategy.capabilities.joinToString(",") { it.name }, capabilities.getAttribute("value"))
    }

    @Test
    fun filesHoldWhatTheReportSays(@TempDir folder: Path) {
        report.writeTo(folder)
        val text = folder.resolve("report.txt").readText()
        fun withoutFiles(text: String) = text.lines().filter { !it.startsWith("  scene file  ") }
        assertEquals(withoutFiles(report.toText()), withoutFiles(text))
        assertEquals(report.toJson(), folder.resolve("report.json").readText())
        assertEquals(report.toJUnitXml(), folder.resolve("TEST-lazyz-conformance.xml").readText())
        assertEquals(report.toHtml(), folder.resolve("report.html").readText())
        val lines = folder.resolve("failures/$nearest.kt").readText().lines()
        assertEquals("// wrong-colors breaks $nearest on this frame:", lines[0])
        assertEquals(1, lines.count { it == "// ${report.commandFor(result(nearest).rule)}" }, "$lines")
        assertTrue(lines.takeWhile { it.isNotEmpty() }.none { "FrameBuilder" in it }, "$lines")
    }

    @Test
    fun fileThatCannotBeReplacedLeavesNoHalfOfAnother(@TempDir folder: Path) {
        folder.resolve("report.html").createDirectories().resolve("mine.txt").writeText("mine")
        assertThrows(IOException::class.java) { report.writeTo(folder) }
        assertEquals(emptyList<String>(), folder.listDirectoryEntries().map { it.name }.filter { ".tmp" in it })
    }
}
