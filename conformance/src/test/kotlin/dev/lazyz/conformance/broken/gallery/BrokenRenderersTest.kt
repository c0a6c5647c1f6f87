package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.TestEffort
import dev.lazyz.conformance.broken.BrokenRenderers
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** Tests the suite: each rule must notice the renderers that break it. */
class BrokenRenderersTest {
    private val own = RuleNames.own
    private val empty = RuleNames.empty

    /**
     * At the suite's default effort, each rule that a mutant names fails, so that no mutant survives or is noticed only
     * by chance.
     */
    @TestFactory
    fun mistakeIsNoticed(): List<DynamicTest> = TestEffort.sample(19, Gallery.all).map { mutant ->
        dynamicTest(mutant.id) {
            val missed = missed(mutant, mutant.noticedBy)

            // A race is only seen if its threads meet, which a busy machine can prevent
            val again = if (mutant in ThreadGallery.mutants && missed.isNotEmpty()) missed(mutant, missed) else missed
            assertEquals(emptySet<String>(), again.toSet(), "rules that did not notice ${mutant.id}")
        }
    }

    private fun missed(mutant: Mutant, rules: List<String>): List<String> =
        rules - SuiteRun.ofRules(rules) { mutant.make() }.failures.keys

    @Test
    fun galleryIsLargeAndItsNamesAreUnique() {
        assertTrue(Gallery.all.size >= 40)
        assertEquals(Gallery.all.size, Gallery.all.map { it.id }.toSet().size)
    }

    @Test
    fun everyRuleNoticesSomeMistake() {
        assertEquals(SuiteRun.rules, Gallery.all.flatMap { it.noticedBy }.toSet())
    }

    @Test
    fun everyRuleSaysWhatItIsFor() {
        for (rule in SuiteRun.rules) {
            val annotation = SuiteRun.annotation(rule)
            for (sentence in listOf(annotation.intent, annotation.look)) assertTrue(sentence.last() in ".?", sentence)
        }
    }

    /** `-Dlazyz.update=true` rewrites the page. */
    @Test
    fun pageIsUpToDate() {
        val docs = listOf("docs", "../docs").map { Path.of(it) }.first { Files.isDirectory(it) }
        val page = docs.resolve("conformance-gallery.md")
        if (System.getProperty("lazyz.update") == "true") Files.writeString(page, Gallery.page())
        val actual = if (Files.exists(page)) Files.readString(page) else ""
        assertEquals(Gallery.page(), actual, "run BrokenRenderersTest with -Dlazyz.update=true to write $page anew")
    }

    @Test
    fun failureIsShrunkAndPrintsTheFrameAndBothAnswers() {
        val message = SuiteRun.ofRule(own, tries = 0.2) { BrokenRenderers.gapsFilled() }.failures.getValue(own).message
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
        val failure = SuiteRun.ofRule(empty, tries = 1.0) { BrokenRenderers.needsAPrimitive() }.failures.getValue(empty)
        assertTrue(failure.message.orEmpty().startsWith("needs-a-primitive: threw java.util.NoSuchElementException"))
        assertTrue(failure.message.orEmpty().contains("FrameBuilder(Raster("))
    }
}
