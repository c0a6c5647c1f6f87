package dev.lazyz.conformance.mutants

import dev.lazyz.conformance.RendererConformance

/** Names of the suite's rules, for tests of the suite. */
internal object RuleNames {
    val nearest = RendererConformance::rule_5_1_nearestFragmentIsVisible.name
    val own = RendererConformance::rule_2_8_customPrimitivesCoverTheirSpans.name
    val tests = RendererConformance::rule_5_3_everyDepthTestIsObeyed.name
    val ties = RendererConformance::rule_5_2_tiesGoToTheFirstSubmitted.name
    val index = RendererConformance::rule_9_4_primitivesThatCoverNothingKeepTheirIndex.name
    val empty = RendererConformance::rule_9_6_framesWithoutPrimitivesShowTheBackground.name
    val many = RendererConformance::rule_9_4_indicesAreNotTruncated.name
    val frames = RendererConformance::rule_7_1_userFramesAreDrawnCorrectly.name
    val outside = RendererConformance::rule_7_7_primitivesOutsideTheRegionAreNotQueried.name
    val tidy = RendererConformance::rule_7_9_renderingsLeaveNothingBehind.name
    val blend = RendererConformance::rule_5_5_translucentPrimitivesBlendInOrderOfDepth.name
    val extremes = RendererConformance::rule_5_5_extremesOfLightAndAlphaBlend.name
    val halves = RendererConformance::rule_2_5_primitivesCutInTwoGiveTheSamePicture.name
    val options = RendererConformance::rule_7_5_optionsChangeNothing.name
    val memoryReport = RendererConformance::rule_8_3_workingMemoryIsReported.name
    val passes = RendererConformance::rule_8_2_visibleSamplesPassTheTestAndAreShaded.name

    /** Rules that notice what happens where threads meet, which depends on chance. */
    val chancy: Set<String> = setOf(
        RendererConformance::rule_7_5_concurrentThreadsLoseNoFragments,
        RendererConformance::rule_8_1_concurrentThreadsLoseNoCounts,
        RendererConformance::rule_7_1_failuresInThreadsReachTheCaller,
        RendererConformance::rule_7_1_primitivesAreNotCalledAfterTheEnd,
        RendererConformance::rule_7_1_interruptedCallersGetNoHalfPicture,
        RendererConformance::rule_7_8_interruptedWorkersFinishTheirWork,
        RendererConformance::rule_7_1_concurrentRenderingsAreIndependent,
        RendererConformance::rule_7_8_sinkIsCalledOnTheCallersThread,
        RendererConformance::rule_7_1_renderingsFromSeveralThreadsAreIdentical,
    ).mapTo(HashSet()) { it.name }
}
