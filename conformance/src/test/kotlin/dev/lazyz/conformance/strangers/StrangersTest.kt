package dev.lazyz.conformance.strangers

import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.TestEffort
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/**
 * What the suite notices of the strangers' wrong renderers, it goes on noticing. A file names for each of them a rule
 * that does, or `-`; see [TestEffort]. `-Dlazyz.record=true` looks for the rules anew, where those in the file do not
 * notice, which takes up to a minute each.
 */
class StrangersTest {
    private val file: Path = listOf("src/test/resources", "conformance/src/test/resources").map { Path.of(it) }
        .first { Files.isDirectory(it) }.resolve("strangers.txt")

    private val page: Path = listOf("..", ".").map { Path.of(it).resolve("docs/conformance.md") }
        .first { Files.exists(it) }

    private val strangers = StrangersGallery.all

    private fun recorded(): Map<String, String> =
        file.readLines().map { it.split(' ') }.associate { (id, rule) -> id to rule }

    @TestFactory
    fun whatWasNoticedIsNoticed(): List<DynamicTest> {
        if (System.getProperty("lazyz.record") == "true") record()
        val recorded = recorded()
        val noticed = strangers.filter { recorded[it.id] != MISSED }
        return TestEffort.sample(30, noticed).map { stranger ->
            dynamicTest(stranger.id) {
                val rule = recorded.getValue(stranger.id)

                // What happens where threads meet is noticed by one rule about them, or by another
                val result = judged(stranger, rule)
                val isNoticed = result.outcome.isFailure ||
                    SuiteRun.rules.any { isChancy(it) && judged(stranger, it).outcome.isFailure }
                assertTrue(isNoticed, "${stranger.id}, ${stranger.what}: $result")
            }
        }
    }

    /** Some break nothing that the contract says clearly, and some counters leave room. */
    @Test
    fun nineOfTenAreNoticed() {
        val recorded = recorded()
        assertEquals(strangers.map { it.id }, recorded.keys.toList(), "the strangers in $file")
        val missed = strangers.filter { recorded[it.id] == MISSED }.map { it.id }
        assertTrue(10 * missed.size <= strangers.size, "of ${strangers.size} strangers are missed: $missed")
        val noticed = "${strangers.size - missed.size} of ${strangers.size} wrong renderers by authors"
        assertTrue(noticed in page.readText(), "docs/conformance.md says: $noticed")
    }

    /** A SHOULD that is not followed is no failure. */
    private fun judged(stranger: Stranger, rule: String): RuleResult =
        SuiteRun.ofRules(listOf(rule), stranger.make).report.results.single()

    private fun isChancy(rule: String): Boolean = "Threads" in rule || "Meet" in rule

    private fun record() {
        // First what the mistake is about, then what is quick, and last what depends on threads that meet
        val usual = SuiteRun.of(1.0) { ZBuffer() }.report.results.sortedBy { it.milliseconds }.map { it.rule }
        val before = if (Files.exists(file)) recorded() else emptyMap()
        val lines = ArrayList<String>()
        for (stranger in strangers) {
            val order = listOfNotNull(before[stranger.id]?.takeIf { it != MISSED }) +
                usual.sortedBy { it.number !in stranger.chapters }.map { it.name }.sortedBy(::isChancy)
            val rule = order.distinct().firstOrNull { judged(stranger, it).outcome.isFailure } ?: MISSED
            lines += "${stranger.id} $rule"
            file.writeLines(
                lines + before.filterKeys { id ->
                    lines.none { it.startsWith("$id ") }
                }.map { (id, was) -> "$id $was" }
            )
        }
    }

    private companion object {
        const val MISSED = "-"
    }
}
