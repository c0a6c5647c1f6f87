package dev.lazyz.conformance

/** Names of the suite's rules, for [Mutant]s. */
internal object RuleNames {
    val nearest = RendererConformance::rule_5_1_nearestFragmentIsVisible.name
    val scenes = RendererConformance::rule_5_1_nearestFragmentIsVisibleInScenes.name
    val own = RendererConformance::rule_2_8_primitivesOfOnesOwnCoverWhatTheySay.name
    val background = RendererConformance::rule_4_3_backgroundIsWhereNothingPasses.name
    val ties = RendererConformance::rule_5_2_tiesGoToTheFirstSubmitted.name
    val tests = RendererConformance::rule_5_3_everyDepthTestIsObeyed.name
    val pairs = RendererConformance::rule_5_3_everyPairInASmallWorldIsRight.name
    val blend = RendererConformance::rule_5_5_translucentPrimitivesBlendInOrderOfDepth.name
    val refuse = RendererConformance::rule_5_6_whoCannotBlendRefuses.name
    val index = RendererConformance::rule_9_4_primitivesThatCoverNothingKeepTheirIndex.name
    val many = RendererConformance::rule_9_4_indicesAreNotCut.name
    val empty = RendererConformance::rule_9_6_framesWithoutPrimitivesAreOrdinary.name
    val narrow = RendererConformance::rule_9_6_narrowRastersAreOrdinary.name
    val moved = RendererConformance::rule_1_3_movingByWholePixelsMovesThePicture.name
    val halves = RendererConformance::rule_2_5_primitivesInTwoPartsAreTheWhole.name
    val hidden = RendererConformance::rule_5_1_hiddenSurfacesChangeNothing.name
    val parts = RendererConformance::rule_5_1_partsMergeIntoTheWhole.name
    val copies = RendererConformance::rule_5_2_duplicatesChangeNothing.name
    val order = RendererConformance::rule_5_4_orderIsIrrelevantWithoutTies.name
    val region = RendererConformance::rule_7_4_regionIsThatPartOfThePicture.name
    val options = RendererConformance::rule_7_5_optionsChangeNothing.name
    val again = RendererConformance::rule_7_1_sameBitsAgain.name
    val threads = RendererConformance::rule_7_1_sameBitsFromSeveralThreads.name
    val accidents = RendererConformance::rule_7_1_exceptionsOfPrimitivesReachTheCaller.name
    val interrupts = RendererConformance::rule_7_1_interruptedThreadsEnd.name
    val sinks = RendererConformance::rule_7_3_exceptionsOfTheSinkReachTheCaller.name
    val rows = RendererConformance::rule_7_3_rowsArriveInOrderEachOnce.name
    val outside = RendererConformance::rule_7_7_whatIsOutsideTheRegionIsLeftAlone.name
    val told = RendererConformance::rule_8_3_workingMemoryIsReported.name
    val counts = RendererConformance::rule_8_1_countersCountWhatHappens.name
    val fragments = RendererConformance::rule_8_1_fragmentsAreTheCoveredSamples.name
    val among = RendererConformance::rule_8_1_passesAreAmongTheFragments.name
    val steps = RendererConformance::rule_8_1_startsAndStepsAreCounted.name
    val passes = RendererConformance::rule_8_2_visibleSamplesArePassedAndShaded.name
    val promise = RendererConformance::rule_8_2_promiseToShadeOnlyTheVisibleIsKept.name
    val memory = RendererConformance::rule_7_3_promiseOfConstantMemoryIsKept.name
    val streams = RendererConformance::rule_7_3_promiseToStreamRowsIsKept.name
    val unpulled = RendererConformance::rule_7_3_rowsThatAreNotPulledCostNothing.name
    val selects = RendererConformance::rule_7_5_selectorsChooseAmongAllFragments.name
    val parallel = RendererConformance::rule_7_5_promiseToWorkInParallelIsKept.name
    val sums = RendererConformance::rule_8_1_countersDoNotDependOnThreads.name
    val budget = RendererConformance::rule_8_1_promiseToKeepToTheBudgetIsKept.name
    val arrivals = RendererConformance::rule_8_1_promiseToStreamPrimitivesIsKept.name
}
