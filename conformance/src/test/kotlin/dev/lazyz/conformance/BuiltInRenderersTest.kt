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
 * Runs the suite on the built-in renderers and on the oracle. By default a fifth of the rules that take short try
 * `zbuffer` with a few frames each, and [StrategiesAgreeProperties] compares the others with it. With the effort
 * `rest`, `lists` is tested by all rules with all their frames, and each of the others by a fifth of those that take
 * short, with a few frames, so that each of these tests several renderers. `full` tests all by all. See [TestEffort].
 */
class BuiltInRenderersTest {
    @TestFactory
    fun passes(): List<DynamicTest> {
        val renderers = if (TestEffort.isDefault) listOf(ZBufferRenderer()) else Renderers.builtIn + ReferenceRenderer()
        return renderers.mapIndexed { i, renderer ->
            dynamicTest(renderer.id) { assertPasses(renderer, rules(i, renderer)) }
        }
    }

    private fun rules(i: Int, renderer: Renderer): Set<String> = when {
        TestEffort.isDefault -> TestEffort.sample(5, SuiteRun.quickRules.toList()).toSet()
        TestEffort.isFull || renderer is ListsRenderer -> SuiteRun.rules
        else -> SuiteRun.quickRules.filterIndexed { k, _ -> (k + i) % 5 == 0 }.toSet()
    }

    private fun assertPasses(renderer: Renderer, rules: Set<String>) {
        val tries = if (TestEffort.isFull || renderer is ListsRenderer) 1.0 else 0.02
        val run = SuiteRun.of(tries, rules) { renderer }

        // The oracle queries every primitive at every sample, whatever the cost
        val excused = if (renderer is ReferenceRenderer) rules intersect setOf(RuleNames.outside) else emptySet()
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
