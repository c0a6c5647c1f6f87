package dev.lazyz.conformance

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** The suite on trial: each rule must notice who breaks it. */
class BrokenRenderersTest {
    /** A mistake, and the rules that must notice it. */
    private class Mistake(val make: () -> BrokenRenderer, vararg val breaks: String)

    private val ties = "rule_5_2_tiesGoToTheFirstSubmitted"
    private val tests = "rule_5_3_everyDepthTestIsObeyed"
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val scenes = "rule_5_1_nearestFragmentIsVisibleInScenes"
    private val order = "rule_5_4_orderIsIrrelevantWithoutTies"
    private val own = "rule_2_8_primitivesOfOnesOwnCoverWhatTheySay"
    private val background = "rule_4_3_backgroundIsWhereNothingPasses"
    private val blend = "rule_5_5_translucentPrimitivesBlendInOrderOfDepth"
    private val refuse = "rule_5_6_whoCannotBlendRefuses"
    private val again = "rule_7_1_sameBitsAgain"
    private val threads = "rule_7_1_sameBitsFromSeveralThreads"
    private val rows = "rule_7_3_rowsArriveInOrderEachOnce"
    private val region = "rule_7_4_regionIsThatPartOfThePicture"
    private val options = "rule_7_5_optionsChangeNothing"
    private val parts = "rule_5_1_partsMergeIntoTheWhole"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"
    private val counts = "rule_8_1_countersCountWhatHappens"
    private val passes = "rule_8_2_visibleSamplesArePassedAndShaded"
    private val index = "rule_9_4_primitivesThatCoverNothingKeepTheirIndex"
    private val empty = "rule_9_6_framesWithoutPrimitivesAreOrdinary"
    private val narrow = "rule_9_6_narrowRastersAreOrdinary"

    /** Seen by other rules too: whatever gives a wrong picture fails wherever pictures are compared. */
    private val wrongPictures = listOf(
        Mistake(BrokenRenderers::lastWinsTies, ties, tests),
        Mistake(BrokenRenderers::colourOfTheLoser, ties, tests),
        Mistake(BrokenRenderers::usualTestOnly, tests),
        Mistake(BrokenRenderers::lastSubmittedWins, nearest, scenes, order),
        Mistake(BrokenRenderers::backgroundAtInfinity, background),
        Mistake(BrokenRenderers::spanEndsEarly, nearest, scenes, narrow),
        Mistake(BrokenRenderers::gapsFilled, nearest, own),
        Mistake(BrokenRenderers::shadesTheNeighbour, nearest, own),
        Mistake(BrokenRenderers::linearFormsOnly, own),
        Mistake(BrokenRenderers::dropsTheInvisible, index, counts, parts),
        Mistake(BrokenRenderers::lastRowMissing, rows, nearest, empty, narrow),
        Mistake(BrokenRenderers::needsAPrimitive, empty),
        Mistake(BrokenRenderers::needsTwoColumns, narrow),
    )

    /** Seen by these rules and no other. */
    private val onlySeenHere = listOf(
        Mistake(BrokenRenderers::bottomUp, rows, region),
        Mistake(BrokenRenderers::firstRowTwice, rows, region),
        Mistake(BrokenRenderers::ignoresTheRegion, region),
        Mistake(BrokenRenderers::optionsMatter, options),
        Mistake(BrokenRenderers::shadesMoreThanItPromises, promise),
        Mistake(BrokenRenderers::remembersTheLastFrame, again, threads, parts),
        Mistake(BrokenRenderers::oneThreadOnly, threads),
        Mistake(BrokenRenderers::takesGlassForOpaque, refuse),
        Mistake(BrokenRenderers::blendsAsSubmitted, blend),
        Mistake(BrokenRenderers::blendsFromTheBack, blend),
        Mistake(BrokenRenderers::blendsBehindTheBackdrop, blend),
        Mistake(BrokenRenderers::depthOfTheBackdrop, blend),
        Mistake(BrokenRenderers::countsTheVisible, counts),
        Mistake(BrokenRenderers::countsACallTooMany, counts, empty),
        Mistake(BrokenRenderers::countsNoPasses, passes),
    )

    @TestFactory
    fun mistakeIsNoticed(): List<DynamicTest> = (wrongPictures + onlySeenHere).map { mistake ->
        dynamicTest(mistake.make().id) {
            val noticed = SuiteRun.of(tries = 0.2) { mistake.make() }.failures.keys
            assertTrue(noticed.containsAll(mistake.breaks.toList())) {
                "${mistake.breaks.toList() - noticed} did not notice; $noticed did"
            }
            if (mistake in onlySeenHere) assertEquals(mistake.breaks.toSet(), noticed)
        }
    }

    @Test
    fun everyRuleNoticesSomeMistake() {
        assertEquals(SuiteRun.rules, (wrongPictures + onlySeenHere).flatMap { it.breaks.toList() }.toSet())
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
