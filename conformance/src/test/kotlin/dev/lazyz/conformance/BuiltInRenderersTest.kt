package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.census.Distribution
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.census.PairsOfTraits
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/**
 * Runs the suite on every built-in renderer and on the oracle, with the efforts `rest` and `full`. By default only
 * [ZBufferConformanceTest] runs it, and [StrategiesAgreeProperties] compares the others with `zbuffer`. `rest` tests
 * the default renderer with all rules, and the others with those that take short and one that takes long; `full` tests
 * all with all rules. See [TestEffort].
 */
class BuiltInRenderersTest {
    @TestFactory
    fun passes(): List<DynamicTest> {
        val renderers = Renderers.builtIn.filter { it !is ZBufferRenderer } + ReferenceRenderer()
        if (TestEffort.isDefault) return emptyList()
        return renderers.mapIndexed { i, renderer ->
            val rules = if (TestEffort.isFull || i == 0) {
                SuiteRun.rules
            } else {
                SuiteRun.quickRules + setOfNotNull(SuiteRun.longRules.elementAtOrNull(i - 1))
            }
            dynamicTest(renderer.id) { assertPasses(renderer, rules) }
        }
    }

    private fun assertPasses(renderer: Renderer, rules: Set<String>) {
        val tries = if (TestEffort.isFull || renderer is ListsRenderer) 1.0 else 0.05
        val run = SuiteRun.of(tries, rules) { renderer }

        // The oracle queries every primitive at every sample, whatever the cost
        val excused = if (renderer is ReferenceRenderer) setOf(RuleNames.outside) else emptySet()
        assertTrue(run.failures.keys.containsAll(excused))
        val failures = run.failures - excused
        assertEquals("", failures.entries.joinToString("\n\n") { (rule, failure) -> "$rule\n${failure.message}" })
        assertEquals(rules, run.rules)
        if (renderer is ListsRenderer) assertMeetsAllPairs(run.report.distribution)
    }

    /** A renderer that blends and supports selectors must be tested with every compatible pair of traits. */
    private fun assertMeetsAllPairs(met: Distribution) {
        val missing = PairsOfTraits.expected.filter { (one, other) -> met.count(one, other) == 0L }
        assertEquals(emptyList<Pair<FrameTrait, FrameTrait>>(), missing)
        val impossible = FrameTrait.entries.flatMap { one -> FrameTrait.entries.filter { it > one }.map { one to it } }
            .filter { (one, other) -> PairsOfTraits.whyNever(one, other) != null && met.count(one, other) > 0 }
        assertEquals(emptyList<Pair<FrameTrait, FrameTrait>>(), impossible)
    }

    @Test
    fun suiteIsExtendedFromJava() {
        val rules = if (TestEffort.isFull) SuiteRun.rules else setOf(RuleNames.own, RuleNames.empty, RuleNames.ties)
        val run = SuiteRun.of(FromJava::class, tries = 0.05, *rules.toTypedArray())
        assertEquals(emptyMap<String, Throwable>(), run.failures)
        assertEquals(rules, run.rules)
    }
}
