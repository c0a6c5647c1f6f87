package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.UnusualRenderers
import dev.lazyz.conformance.mutants.skeletons.Skeletons
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.strategies.Renderers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/**
 * Correct renderers pass with other frames, however they work. `-Dlazyz.seeds=1..20 -Dsurefire.timeout=0` tests all of
 * them, including third-party ones, with these seeds and the default effort, for an hour, and prints which have passed.
 * `-Dlazyz.effort=rest` tests one of them with one seed, a twentieth of the frames, and a third of the quick rules.
 */
class OtherSeedsTest {
    private val seeds: LongRange? = System.getProperty("lazyz.seeds")?.let { range ->
        val (first, last) = range.split("..").map { it.toLong() }
        first..last
    }

    /** Without seeds, [BuiltInRenderersTest] is enough. */
    @TestFactory
    fun builtInRenderersPass(): List<DynamicTest> {
        val all = if (seeds == null) emptyList() else Renderers.builtIn
        return passing(all.map { { it } }, setOf(RuleOutcome.PASSED, RuleOutcome.NOT_SUPPORTED))
    }

    @TestFactory
    fun unusualRenderersPass(): List<DynamicTest> {
        val oracle = { ReferenceRenderer() }
        val all = UnusualRenderers.all + Skeletons.correct + oracle
        val good = RuleOutcome.entries.filterNot { it.isFailure }.toSet()
        val some = if (TestEffort.isDefault) emptyList() else UnusualRenderers.quick.take(1)
        return passing(if (seeds == null) some else all, good)
    }

    private fun passing(renderers: List<() -> Renderer>, good: Set<RuleOutcome>): List<DynamicTest> {
        val tries = if (seeds == null) 0.05 else 1.0
        val quick = TestEffort.sample(3, SuiteRun.quickRules.toList())
        val rules = SuiteRule.all.filter { seeds != null || it.name in quick }
        return renderers.flatMap { make ->
            (seeds ?: 1L..1L).map { seed ->
                dynamicTest("${make().id} at seed $seed") {
                    val judge = Conformance { make() }.seed(seed).tries(tries)
                    rules.forEach { judge.rule(it.name) }
                    val report = judge.run()
                    val broken = report.results.filterNot { it.outcome in good }.map { it.rule }
                    assertEquals(emptyList<SuiteRule>(), broken) { report.toText() }
                    assertEquals(rules, report.results.map { it.rule })
                    if (seeds != null) println("${make().id} passes at seed $seed")
                }
            }
        }
    }
}
