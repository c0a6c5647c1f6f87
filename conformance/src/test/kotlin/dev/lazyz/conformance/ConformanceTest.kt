package dev.lazyz.conformance

import dev.lazyz.Capability
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.run.RunUnderWay
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The suite as a library: its options and its report. */
class ConformanceTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"

    private fun of(renderer: PlainRenderer, rule: String = nearest) = Conformance { renderer }.rule(rule).tries(0.1)

    @Test
    fun otherSeedsTryOtherFrames() {
        val usual = of(PlainRenderer()).run()
        val other = of(PlainRenderer()).seed(7).run()
        assertEquals(7, other.seed)
        assertNotEquals(usual.distribution, other.distribution)
        assertNotEquals(of(PlainRenderer()).explore().run().seed, of(PlainRenderer()).explore().run().seed)
    }

    @Test
    fun rulesAreChosenByNameOrNumber() {
        val report = Conformance { PlainRenderer() }.rule("5.1").rule(promise).tries(0.01).run()
        val names = report.results.map { it.rule.name }
        assertEquals(SuiteRule.all.filter { it.number == "5.1" }.map { it.name } + promise, names)
        assertThrows(IllegalArgumentException::class.java) { Conformance { PlainRenderer() }.rule("rule_0_0_none") }
    }

    @Test
    fun failureReportsTheSampleTheFrameAndHowToSeeItAgain() {
        val report = of(WrongColors()).run()
        assertFalse(report.isConformant)
        val failure = checkNotNull(report.results.single().failure)
        val sample = checkNotNull(failure.sample)
        assertEquals(0, sample.x)
        assertTrue("sample (${sample.x}, ${sample.y}) is the first of" in failure.message)
        assertTrue(sample.expected in failure.message && sample.actual in failure.message)
        assertTrue(failure.code.orEmpty().startsWith("FrameBuilder(Raster("))
        assertNotEquals(failure.expected, failure.actual)
        val command = report.commandFor(report.results.single().rule)
        assertTrue(command.startsWith("zcli conformance --strategy wrong-colors --classpath /"), command)
        assertTrue(command.endsWith(" --seed 1995 --tries 0.1 --rule $nearest"), command)
    }

    @Test
    fun ruleForACapabilityThatIsNotDeclaredDoesNotApply() {
        val result = of(PlainRenderer(), promise).run().results.single()
        assertEquals(RuleOutcome.NOT_SUPPORTED, result.outcome)
        assertEquals("SHADES_ONLY_VISIBLE is not declared", result.message)
        assertEquals(1, result.tries)
        assertFalse(result.outcome.isFailure)
    }

    @Test
    fun distributionCountsTheFramesThatWereTried() {
        val distribution = Conformance {
            ZBufferRenderer()
        }.rule("rule_5_2_tiesGoToTheFirstSubmitted").tries(0.5).run().distribution
        assertEquals(100, distribution.frames)
        assertTrue(distribution.count(FrameTrait.TIE) in 20..99, "$distribution")
        assertTrue(distribution.count(FrameTrait.HIDDEN) >= distribution.count(FrameTrait.TIE), "$distribution")
        val regions = Conformance { ZBufferRenderer() }.rule("7.4").tries(0.5).run().distribution
        assertTrue(regions.count(FrameTrait.REGION) > 25, "$regions")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun secondRunAtTheSameTimeIsAnError() {
        val inner = object : PlainRenderer("nested") {
            override val capabilities: Set<Capability>
                get() = if (RunUnderWay.current == null) emptySet() else of(PlainRenderer()).run().let { emptySet() }
        }
        val result = of(inner, promise).run().results.single()
        assertEquals(RuleOutcome.FAILED, result.outcome)
        assertTrue("one at a time" in result.message, result.message)
        assertTrue(of(PlainRenderer()).run().isConformant)
    }
}
