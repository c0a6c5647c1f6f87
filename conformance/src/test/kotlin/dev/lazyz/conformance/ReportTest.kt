package dev.lazyz.conformance

import dev.lazyz.scenes.scenefile.SceneFile
import java.io.ByteArrayInputStream
import java.nio.file.Path
import java.util.Base64
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory
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
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** A report in its four forms, and on disk. */
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
    fun textBeginsWithWaiversAndEndsWithTheVerdict() {
        val text = report(WrongColors(), nearest, "8.2", rows).toText()
        val parts = listOf(
            "strategy      wrong-colors (", "\nWaivers\n  $rows (waived but passes)\n", "\nFAILED: $nearest (MUST)\n",
            "    expected #", "reproduce   zcli conformance ", "\nWAIVED BUT PASSES: $rows", " tries  ",
            "\nnot applicable     rule_8_2_", "something is hidden",
            "wrong-colors does NOT conform: 4 rules, 1 passed, 1 failed, 1 waived but",
        )
        assertEquals(parts.map { text.indexOf(it) }.sorted(), parts.map { text.indexOf(it) }, text)
        assertTrue(parts.all { it in text }, text)
        assertTrue("conforms: 1 rules" in report(PlainRenderer(), nearest).toText())
    }

    @Test
    fun jsonHasAllThereIsToKnow() {
        val json = Json.parseToJsonElement(report(WrongColors(), nearest, rows).toJson()).jsonObject
        assertEquals("false", json.getValue("conformant").jsonPrimitive.content)
        assertEquals("1995", json.getValue("seed").jsonPrimitive.content)
        val waiver = json.getValue("waivers").jsonArray[0].jsonObject
        assertEquals("9999-01-01", waiver.getValue("expires").jsonPrimitive.content)
        val rules = json.getValue("rules").jsonArray.map { it.jsonObject }
        assertEquals(listOf("failed", "waivedButPasses"), rules.map { it.getValue("outcome").jsonPrimitive.content })
        val failure = rules[0].getValue("failure").jsonObject
        assertEquals(setOf("message", "sample", "frame", "command"), failure.keys)
        assertTrue("severalVisible" in json.getValue("distribution").jsonObject)
    }

    @Test
    fun xmlHasATestCaseARule() {
        for (renderer in listOf(WrongColors(), Throwing())) {
            val xml = report(renderer, nearest, "8.2", rows).toJUnitXml()
            val suite = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(ByteArrayInputStream(xml.toByteArray())).documentElement
            assertEquals("4", suite.getAttribute("tests"))
            assertEquals(suite.getAttribute("failures"), "${suite.getElementsByTagName("failure").length}")
            assertEquals(suite.getAttribute("skipped"), "${suite.getElementsByTagName("skipped").length}")
            assertEquals(4, suite.getElementsByTagName("testcase").length)
        }
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
        assertFalse("<script" in html || Regex("""(src|href)="(?!data:)""").containsMatchIn(html))
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
        assertFalse(folder.resolve("failures/$nearest.json").exists())
        assertTrue(SceneFile.read(folder.resolve("failures/$scenes.json")).scene.lights.isEmpty())
    }

    @Test
    fun nothingIsLeftOfFailuresThatAreMended() {
        report(WrongColors(), nearest).writeTo(folder)
        report(PlainRenderer(), nearest).writeTo(folder)
        assertFalse(folder.resolve("failures").exists())
    }
}
