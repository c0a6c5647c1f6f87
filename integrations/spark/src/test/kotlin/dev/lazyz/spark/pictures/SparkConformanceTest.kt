package dev.lazyz.spark.pictures

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.spark.TestSpark
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The conformance suite on bands that are tasks. A rendering takes some 20 ms, so a build tries few frames. */
class SparkConformanceTest {
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun someRulesAreKept() {
        keeps(SuiteRule.all.filterIndexed { i, rule -> i % 8 == 1 && rule.name !in LONG })
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun allRulesAreKept() {
        keeps(SuiteRule.all)
    }

    private fun keeps(rules: List<SuiteRule>) {
        val suite = Conformance { SparkRenderer(TestSpark.session) }.tries(0.01)
        for (rule in rules) if (rule.name !in SPARKS_OWN) suite.rule(rule.name)
        val report = suite.run()
        assertTrue(report.isConformant) { report.toText() }
    }

    private companion object {
        /** Spark itself keeps data of its last thousand jobs, and ends a task whose thread is interrupted. */
        val SPARKS_OWN = setOf("rule_7_9_renderingsHoldNoMoreMemory", "rule_7_8_interruptedWorkersFinishTheirWork")

        /** Rules that try the same number of frames, or take the same time, whatever the effort. */
        val LONG = setOf(
            "rule_5_3_allPairsOnATinyRasterAreDrawnCorrectly",
            "rule_7_9_renderingsLeaveNothingBehind",
            "rule_1_1_columnsAndRowsAreNotTruncated",
        )
    }
}
