package dev.lazyz.conformance.results

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.WrongColors
import java.nio.file.Path
import java.time.LocalDate
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class WaiversTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"

    private fun text(rule: String = nearest, expires: String = "9999-12-31") =
        "# known\n\nrule: $rule\nreason: colours: see below\nlink: https://example.org/7\nexpires: $expires\n"

    private fun outcome(renderer: PlainRenderer, expires: String = "9999-12-31", rule: String = nearest): RuleResult {
        val waivers = Waivers.parse(text(rule, expires))
        return Conformance { renderer }.rule(rule).tries(0.05).waivers(waivers).run().results.single()
    }

    @Test
    fun fileIsReadBlockByBlock() {
        val other = "rule_7_3_rowsArriveInOrderEachOnce"
        val waivers = Waivers.parse(text() + "\n\n" + text(other).trim()).all
        assertEquals(listOf(nearest, other), waivers.map { it.rule })
        assertEquals("colours: see below", waivers[0].reason)
        assertEquals("https://example.org/7", waivers[0].link)
        assertEquals(LocalDate.of(9999, 12, 31), waivers[0].expires)
        assertEquals(0, Waivers.parse("").all.size)
    }

    @Test
    fun mistakesAreReportedWithFileAndLine() {
        for ((text, message) in listOf(
            text("rule_5_1_nearest") to "w.txt:3: no rule 'rule_5_1_nearest'; did you mean rule_5_1_",
            text("other") to "w.txt:3: no rule 'other'",
            text(expires = "2027-02-30") to "w.txt:6: not a date such as 2027-01-31: 2027-02-30",
            text().replace("link: https://example.org/7\n", "") to "w.txt:3: the block that begins here has no 'link:'",
            text().replace("https://example.org/7", "") to "w.txt:5: 'link:' has no value",
            text().replace("link:", "url:") to "w.txt:5: expected 'rule:', 'reason:', 'link:', 'expires:': url: https",
            text() + text().substringAfter("\n\n") to "w.txt:7: 'rule:' twice in one block; is an empty line missing?",
            text() + "\n" + text() to "is waived twice",
        )) {
            val e = assertThrows(WaiversException::class.java) { Waivers.parse(text, "w.txt") }
            assertTrue(message in e.message.orEmpty(), "${e.message}, not $message")
        }
        val missing = assertThrows(WaiversException::class.java) { Waivers.read(Path.of("no-such-file")) }
        assertTrue("cannot read the waivers file no-such-file" in missing.message.orEmpty())
    }

    @Test
    fun waivedRuleThatFailsIsNoFailure() {
        val result = outcome(WrongColors())
        assertEquals(RuleOutcome.WAIVED, result.outcome)
        assertFalse(result.outcome.isFailure)
        assertEquals("waived until 9999-12-31: colours: see below (https://example.org/7)", result.message)
        assertTrue("is the first of" in result.failure?.message.orEmpty())
    }

    @Test
    fun waivedRuleThatPassesIsAFailure() {
        val result = outcome(PlainRenderer())
        assertEquals(RuleOutcome.WAIVED_BUT_PASSES, result.outcome)
        assertTrue(result.outcome.isFailure)
        val inapplicable = outcome(PlainRenderer(), rule = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept")
        assertEquals(RuleOutcome.WAIVED_BUT_PASSES, inapplicable.outcome)
        assertEquals("has a waiver, but is not supported: delete the waiver", inapplicable.message)
    }

    @Test
    fun waiverHoldsOnItsLastDayAndNoLonger() {
        assertEquals(RuleOutcome.WAIVED, outcome(WrongColors(), LocalDate.now().toString()).outcome)
        for (renderer in listOf(PlainRenderer(), WrongColors())) {
            val result = outcome(renderer, LocalDate.now().minusDays(1).toString())
            assertEquals(RuleOutcome.WAIVER_EXPIRED, result.outcome)
            assertTrue(result.outcome.isFailure)
        }
    }

    @Test
    fun systemPropertyNamesTheFile(@TempDir folder: Path) {
        val file = folder.resolve("waivers.txt").apply { writeText(text()) }
        SuiteRun.withProperty(Waivers.PROPERTY, "$file") {
            val report = Conformance { WrongColors() }.rule(nearest).tries(0.05).run()
            assertEquals(RuleOutcome.WAIVED, report.results.single().outcome)
            assertEquals(nearest, report.waivers.single().rule)
        }
    }
}
