package dev.lazyz.conformance.report

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.Throwing
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.conformance.mutants.wrappers.MannerMistakes
import dev.lazyz.conformance.mutants.wrappers.PromiseMistakes
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.scenes.formats.Scenes
import java.io.ByteArrayInputStream
import java.nio.file.Path
import java.util.Base64
import javax.imageio.ImageIO
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** A report in its four formats, and on disk. */
class ReportTest {
    @TempDir
    lateinit var folder: Path

    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val scenes = "rule_5_1_nearestFragmentIsVisibleInScenes"
    private val rows = "rule_7_3_rowsArriveInOrderEachOnce"
    private val waiver = "rule: $rows\nreason: <none>\nlink: https://example.org/7\nexpires: 9999-01-01\n"

    private fun report(renderer: PlainRenderer, vararg rules: String): ConformanceReport {
        val conformance = Conformance { renderer }.tries(0.05).waivers(Waivers.parse(waiver))
        for (rule in rules) conformance.rule(rule)
        return conformance.run()
    }

    @Test
    fun textBeginsAndEndsWithTheVerdict() {
        val text = report(WrongColors(), nearest, "8.2", rows).toText()
        val parts = listOf(
            "\n\nLikely cause\n  1. $nearest: it is the only broken rule\n     Check the sample ",
            "strategy      wrong-colors (", "\nWaivers\n  $rows (waived but passes)\n", "\nFAILED: $nearest (MUST)\n",
            "    expected #", "reproduce   zcli conformance ", "\nWAIVED BUT PASSES: $rows", " tries  ",
            "\nnot supported      rule_8_2_", "something is hidden",
        )
        val count = 2 + SuiteRule.all.count { it.number == "8.2" }
        val verdict = "wrong-colors does NOT conform: $count rules, 1 passed, 1 failed, 1 waived but"
        assertTrue(text.startsWith(verdict) && text.trimEnd().lines().last().startsWith(verdict), text)
        assertEquals(parts.map { text.indexOf(it) }.sorted(), parts.map { text.indexOf(it) }, text)
        assertTrue(parts.all { it in text }, text)
        assertTrue("conforms: 1 rule, " in report(PlainRenderer(), nearest).toText())
    }

    @Test
    fun pageHoldsThePicturesItShows() {
        val html = report(WrongColors(), nearest, rows).toHtml()
        val pictures = Regex("data:image/png;base64,([^\"]+)\"").findAll(html).map {
            ImageIO.read(ByteArrayInputStream(Base64.getDecoder().decode(it.groupValues[1])))
        }.toList()
        assertEquals(3, pictures.size)
        assertTrue(pictures.all { maxOf(it.width, it.height) >= 40 })
        assertEquals(0xFFD02020.toInt(), pictures[2].getRGB(0, 0))
        assertFalse("<script" in html || Regex("""(src|href)="(?!data:|#)""").containsMatchIn(html))
        val throwing = report(Throwing(), nearest).toHtml()
        assertTrue("no &lt;primitives&gt; &amp; no &quot;wonder&quot;\uFFFD" in throwing)
    }

    @Test
    fun failureIsOnDisk() {
        val old = folder.resolve("failures").createDirectories().resolve("$rows.kt").apply { writeText("old") }
        val mine = folder.resolve("failures/mine.txt").apply { writeText("mine") }
        report(WrongColors(), nearest, scenes, rows).writeTo(folder)
        val files = listOf("report.html", "report.json", "report.txt", "TEST-lazyz-conformance.xml", "failures")
        assertEquals(files.sorted(), folder.listDirectoryEntries().map { it.name }.sorted())
        assertFalse(old.exists())
        assertTrue(mine.exists())
        val snippet = folder.resolve("failures/$nearest.kt").readText()
        assertTrue("import dev.lazyz.*\n" in snippet && "val frame: Frame =\n    FrameBuilder(" in snippet, snippet)
        for (name in listOf("expected", "actual", "difference")) {
            assertTrue(ImageIO.read(folder.resolve("failures/$nearest-$name.png").toFile()).width >= 40)
        }
        for (rule in listOf(nearest, scenes)) assertTrue(folder.resolve("failures/$rule.json").exists())
        assertTrue("\n// zcli render $nearest.json --strategy wrong-colors -o $nearest.png\n" in snippet, snippet)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun sceneFileOfAFailureReproducesTheDifference() {
        val ties = BasicMistakes.lastWinsTies()
        for ((rule, wrong) in mapOf("5.2" to ties, "7.4" to MannerMistakes.regionOffsetTwice())) {
            val report = Conformance { wrong }.tries(1.0).rule(rule).run()
            report.writeTo(folder)
            val result = report.withOutcome(RuleOutcome.FAILED).first()
            val failure = checkNotNull(result.failure)
            val case = checkNotNull(failure.case)
            assertTrue(case.frame.primitives.isNotEmpty() || rule == "7.4", failure.message)
            val loaded = Scenes.load(folder.resolve("failures/${result.rule}.json"))
            val size = checkNotNull(loaded.size)
            val frame = loaded.scene.frame(loaded.raster(size.width, size.height)).within(case.frame.region)
            assertNull(difference(checkNotNull(failure.expected), ReferenceRenderer().render(frame)))
            val again = difference(ReferenceRenderer().render(frame), Recording.of(wrong, frame).image)
            val sample = checkNotNull(failure.sample)
            assertEquals(
                listOf(sample.x, sample.y, sample.count, sample.expected, sample.actual),
                again?.run { listOf(x, y, count, expectedAnswer, actualAnswer) },
            )
        }
    }

    @Test
    fun frameWithoutASceneFileSaysSo() {
        val own = "rule_2_8_customPrimitivesCoverTheirSpans"
        val report = Conformance { BasicMistakes.gapsFilled() }.tries(0.2).rule(own).run()
        report.writeTo(folder)
        val rule = report.results.single().rule
        assertFalse(folder.resolve("failures/$rule.json").exists())
        val words = "none: a scene file cannot express this frame, but the code makes it"
        assertTrue("scene file  $words\n" in folder.resolve("report.txt").readText(), report.toText())
        assertTrue("\n// scene file: $words\n" in folder.resolve("failures/$rule.kt").readText())
    }

    @Test
    fun whatIsNotFollowedIsReportedAndDoesNoHarm() {
        val rule = "rule_8_3_workingMemoryIsReported"
        val report = Conformance { PromiseMistakes.reportsNoMemory() }.tries(0.1).rule(rule).run()
        assertTrue(report.isConformant)
        val result = report.results.single()
        assertEquals(RuleOutcome.NOT_FOLLOWED, result.outcome)
        assertTrue("a primitive is visible, but peakBytes is 0" in result.message, result.message)
        val text = report.toText()
        assertTrue("\nNOT FOLLOWED: $rule (SHOULD)\n" in text && " conforms: 1 rule, 1 not followed;" in text, text)
        val json = Json.parseToJsonElement(report.toJson()).jsonObject
        assertEquals("true", json.getValue("conformant").jsonPrimitive.content)
        assertEquals("1", json.getValue("outcomes").jsonObject.getValue("notFollowed").jsonPrimitive.content)
        val reported = json.getValue("rules").jsonArray.single().jsonObject
        assertEquals("SHOULD", reported.getValue("level").jsonPrimitive.content)
        assertEquals("notFollowed", reported.getValue("outcome").jsonPrimitive.content)
        assertTrue("failure" in reported)
        val xml = report.toJUnitXml()
        assertTrue("failures=\"0\"" in xml && "skipped=\"1\"" in xml, xml)
        assertTrue("<skipped message=\"not followed: reports-no-memory: a primitive is visible" in xml, xml)
        val html = report.toHtml()
        assertTrue("<h2>Not followed</h2>" in html && "<h2>Failures</h2>" !in html, html)
        report.writeTo(folder)
        assertTrue(folder.resolve("failures/$rule.kt").exists())
    }

    @Test
    fun nothingIsLeftOfFailuresThatAreMended() {
        report(WrongColors(), nearest).writeTo(folder)
        report(PlainRenderer(), nearest).writeTo(folder)
        assertFalse(folder.resolve("failures").exists())
    }
}
