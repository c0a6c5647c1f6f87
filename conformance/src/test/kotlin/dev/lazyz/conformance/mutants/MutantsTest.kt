package dev.lazyz.conformance.mutants

import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.TestEffort
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** Tests the suite: each rule must notice the renderers that break it. */
class MutantsTest {
    private val own = RuleNames.own
    private val empty = RuleNames.empty

    /**
     * At the suite's default effort, each rule that a mistake names fails, so that none is noticed only by chance. See
     * [TestEffort].
     */
    @TestFactory
    fun mistakeIsNoticed(): List<DynamicTest> = TestEffort.sample(50, Mistakes.all).map { mistake ->
        dynamicTest(mistake.id) {
            val missed = missed(mistake, mistake.noticedBy)

            // A race is only seen if its threads meet, which a busy machine can prevent
            val again = if (missed.any(::isChancy)) missed(mistake, missed) else missed
            assertEquals(emptySet<String>(), again.toSet(), "rules that did not notice ${mistake.id}, ${mistake.what}")
        }
    }

    private fun missed(mistake: Mistake, rules: List<String>): List<String> =
        rules - SuiteRun.ofRules(rules) { mistake.make() }.failures.keys

    private fun isChancy(rule: String): Boolean = rule in RuleNames.chancy

    @Test
    fun eachMistakeHasItsOwnLine() = assertEquals(Mistake.noticed.keys.sorted(), Mistakes.all.map { it.id }.sorted())

    @Test
    fun everyRuleNoticesSomeMistake() = assertEquals(SuiteRun.rules, Mistakes.all.flatMap { it.noticedBy }.toSet())

    @Test
    fun everyRuleSaysWhatItIsFor() {
        for (rule in SuiteRun.rules) {
            val annotation = SuiteRun.annotation(rule)
            for (sentence in listOf(annotation.intent, annotation.look)) assertTrue(sentence.last() in ".?", sentence)
        }
    }

    @Test
    fun failureIsShrunkAndPrintsTheFrameAndBothAnswers() {
        val message = SuiteRun.ofRule(own, tries = 0.2) { BasicMistakes.gapsFilled() }.failures.getValue(own).message
        val expected = Regex(
            """
            gaps-filled: sample \([0-9], [0-9]\) is the first of 1 that differ
                expected #ffffffff, depth 2147483647, the background
                but was  #[0-9a-f]{8}, depth [0-9]+, primitive 0
            in
            FrameBuilder\(Raster\([1-9], [1-9], Rgba.WHITE, DepthConvention.SMALLER_IS_NEARER, DepthTest.LESS, .*\)\)
                .add\(Confetti\(-?[0-9], 0, [3-9], 0, [1-9], 1.*\)\)
                .build\(\)
            """.trimIndent(),
        )
        assertTrue(expected.matches(message.orEmpty())) { message }
    }

    @Test
    fun exceptionIsReportedWithTheFrame() {
        val failure = SuiteRun.ofRule(empty, tries = 1.0) { BasicMistakes.needsAPrimitive() }.failures.getValue(empty)
        assertTrue(failure.message.orEmpty().startsWith("needs-a-primitive: threw java.util.NoSuchElementException"))
        assertTrue(failure.message.orEmpty().contains("FrameBuilder(Raster("))
    }
}
