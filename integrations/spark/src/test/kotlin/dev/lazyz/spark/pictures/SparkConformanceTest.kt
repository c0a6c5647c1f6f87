package dev.lazyz.spark.pictures

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.spark.TestSpark
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The conformance suite on bands that are tasks. A rendering takes some 20 ms, so a build tries few frames. */
class SparkConformanceTest {
    private fun conformance() = Conformance { SparkRenderer(TestSpark.session) }.tries(0.01)

    @Test
    fun rulesAreKept() {
        val suite = conformance()
        val (step, first) = if (System.getProperty("lazyz.effort") == null) Pair(9, 0) else Pair(3, 1)
        val some = SuiteRule.all.filterIndexed { i, rule -> i % step == first && rule.name !in LONG }
        for (rule in some) suite.rule(rule.name)
        val report = suite.run()
        assertTrue(report.isConformant) { report.toText() }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun allRulesAreKept() {
        val report = conformance().run()
        assertTrue(report.isConformant) { report.toText() }
    }

    private companion object {
        /** Rules that try the same number of frames, or take the same time, whatever the effort. */
        val LONG = setOf(
            "rule_5_3_allPairsOnATinyRasterAreDrawnCorrectly",
            "rule_7_9_renderingsLeaveNothingBehind",
            "rule_1_1_columnsAndRowsAreNotTruncated",
        )
    }
}
