package dev.lazyz.conformance.mutants

import dev.lazyz.conformance.RendererConformance

/** Names of the suite's rules, for [Mistake]s. */
internal object RuleNames {
    val nearest = RendererConformance::rule_5_1_nearestFragmentIsVisible.name
    val scenes = RendererConformance::rule_5_1_nearestFragmentIsVisibleInScenes.name
    val own = RendererConformance::rule_2_8_customPrimitivesCoverTheirSpans.name
    val bounds = RendererConformance::rule_2_8_boundsMayBeLargerThanTheRaster.name
    val points = RendererConformance::rule_2_9_pointsAreDrawnCorrectly.name
    val lines = RendererConformance::rule_2_10_linesAreDrawnCorrectly.name
    val pointsBlend = RendererConformance::rule_5_5_pointsAndLinesBlend.name
    val background = RendererConformance::rule_4_3_backgroundIsVisibleWhereNoFragmentPasses.name
    val ties = RendererConformance::rule_5_2_tiesGoToTheFirstSubmitted.name
    val tests = RendererConformance::rule_5_3_everyDepthTestIsObeyed.name
    val pairs = RendererConformance::rule_5_3_allPairsOnATinyRasterAreDrawnCorrectly.name
    val blend = RendererConformance::rule_5_5_translucentPrimitivesBlendInOrderOfDepth.name
    val blended = RendererConformance::rule_5_5_translucentMaterialsBlendInOrderOfDepth.name
    val turned = RendererConformance::rule_6_5_normalsOfBackFacesAreTurnedToTheViewer.name
    val lit = RendererConformance::rule_6_5_litAndTexturedScenesAreShadedCorrectly.name
    val footprints = RendererConformance::rule_6_6_texturesAreReadWithTheirOwnFootprints.name
    val refuse = RendererConformance::rule_5_6_renderersWithoutTransparencyRefuseTranslucentFrames.name
    val refuseHidden = RendererConformance::rule_5_6_hiddenTranslucentPrimitivesAreRefused.name
    val extremes = RendererConformance::rule_5_5_extremesOfLightAndAlphaBlend.name
    val flecks = RendererConformance::rule_6_1_everySampleIsShadedSeparately.name
    val unset = RendererConformance::rule_6_1_coloursThatAreNotSetAreBlack.name
    val packed = RendererConformance::rule_6_4_coloursOfAnyBrightnessArePacked.name
    val workers = RendererConformance::rule_7_1_failuresInThreadsReachTheCaller.name
    val finish = RendererConformance::rule_7_8_interruptedWorkersFinishTheirWork.name
    val late = RendererConformance::rule_7_1_primitivesAreNotCalledAfterTheEnd.name
    val halfDone = RendererConformance::rule_7_1_interruptedCallersGetNoHalfPicture.name
    val showing = RendererConformance::rule_8_2_blendedFragmentsAreShadedOnlyIfVisible.name
    val oneByOne = RendererConformance::rule_7_10_primitivesOneByOneGiveTheSamePicture.name
    val ended = RendererConformance::rule_7_10_endedPicturesCannotBeContinued.name
    val unsupported = RendererConformance::rule_7_5_optionsThatAreNotSupportedAreRefused.name
    val index = RendererConformance::rule_9_4_primitivesThatCoverNothingKeepTheirIndex.name
    val many = RendererConformance::rule_9_4_indicesAreNotTruncated.name
    val empty = RendererConformance::rule_9_6_framesWithoutPrimitivesShowTheBackground.name
    val narrow = RendererConformance::rule_9_6_narrowRastersAreDrawnCorrectly.name
    val tiles = RendererConformance::rule_1_1_rastersOfSeveralTilesAreDrawnCorrectly.name
    val far = RendererConformance::rule_1_1_columnsAndRowsAreNotTruncated.name
    val manySpans = RendererConformance::rule_2_3_allSpansOfARowAreDrawn.name
    val thousandsOfSpans = RendererConformance::rule_2_3_thousandsOfSpansAreDrawn.name
    val million = RendererConformance::rule_5_5_millionFragmentsBlend.name
    val deep = RendererConformance::rule_5_1_nearestOfDozensOfLayersIsVisible.name
    val thousands = RendererConformance::rule_5_1_nearestOfThousandsOfLayersIsVisible.name
    val thin = RendererConformance::rule_5_5_dozensOfThinLayersBlend.name
    val thousand = RendererConformance::rule_5_5_thousandThinLayersBlend.name
    val floats = RendererConformance::rule_9_4_indicesAboveTwoToThe24AreExact.name
    val together = RendererConformance::rule_7_5_combinationsAreRight.name
    val moved = RendererConformance::rule_1_3_movingByWholePixelsMovesThePicture.name
    val halves = RendererConformance::rule_2_5_primitivesCutInTwoGiveTheSamePicture.name
    val hidden = RendererConformance::rule_5_1_hiddenSurfacesChangeNothing.name
    val parts = RendererConformance::rule_5_1_mergedPartsEqualTheWholePicture.name
    val copies = RendererConformance::rule_5_2_duplicatesChangeNothing.name
    val order = RendererConformance::rule_5_4_orderIsIrrelevantWithoutTies.name
    val region = RendererConformance::rule_7_4_regionEqualsThatPartOfThePicture.name
    val layersOfRegion = RendererConformance::rule_7_4_regionsOfManyLayersAreDrawnCorrectly.name
    val tileSizes = RendererConformance::rule_7_5_tilesOfEverySizeGiveTheSamePicture.name
    val options = RendererConformance::rule_7_5_optionsChangeNothing.name
    val again = RendererConformance::rule_7_1_repeatedRenderingsAreIdentical.name
    val frames = RendererConformance::rule_7_1_userFramesAreDrawnCorrectly.name
    val threads = RendererConformance::rule_7_1_renderingsFromSeveralThreadsAreIdentical.name
    val meets = RendererConformance::rule_7_1_concurrentRenderingsAreIndependent.name
    val lost = RendererConformance::rule_7_5_concurrentThreadsLoseNoFragments.name
    val lostCounts = RendererConformance::rule_8_1_concurrentThreadsLoseNoCounts.name
    val caller = RendererConformance::rule_7_8_sinkIsCalledOnTheCallersThread.name
    val overwrites = RendererConformance::rule_7_8_sinkMayOverwriteItsRows.name
    val status = RendererConformance::rule_7_8_interruptIsNotLost.name
    val kept = RendererConformance::rule_7_1_nothingIsKeptBetweenCalls.name
    val accidents = RendererConformance::rule_7_1_exceptionsOfPrimitivesReachTheCaller.name
    val interrupts = RendererConformance::rule_7_1_interruptedThreadsEnd.name
    val sinks = RendererConformance::rule_7_3_exceptionsOfTheSinkReachTheCaller.name
    val rows = RendererConformance::rule_7_3_rowsArriveInOrderEachOnce.name
    val outside = RendererConformance::rule_7_7_primitivesOutsideTheRegionAreNotQueried.name
    val memoryReport = RendererConformance::rule_8_3_workingMemoryIsReported.name
    val counts = RendererConformance::rule_8_1_countersEqualTheObservedCalls.name
    val fragments = RendererConformance::rule_8_1_fragmentsEqualTheCoveredSamples.name
    val among = RendererConformance::rule_8_1_passesAreAtMostTheFragments.name
    val stepping = RendererConformance::rule_8_1_shadingStepsFollowTheOptions.name
    val steps = RendererConformance::rule_8_1_startsAndStepsAreCounted.name
    val passes = RendererConformance::rule_8_2_visibleSamplesPassTheTestAndAreShaded.name
    val promise = RendererConformance::rule_8_2_promiseToShadeOnlyTheVisibleIsKept.name
    val memory = RendererConformance::rule_7_3_promiseOfConstantMemoryIsKept.name
    val streams = RendererConformance::rule_7_3_promiseToStreamRowsIsKept.name
    val unpulled = RendererConformance::rule_7_3_rowsAfterTheSinkStopsAreNotRendered.name
    val selects = RendererConformance::rule_7_5_selectorsChooseAmongAllFragments.name
    val called = RendererConformance::rule_7_5_selectorsAreCalledOncePerSample.name
    val chosen = RendererConformance::rule_7_5_selectorsChooseAmongAThousandFragments.name
    val parallel = RendererConformance::rule_7_5_promiseToWorkInParallelIsKept.name
    val sums = RendererConformance::rule_8_1_countersDoNotDependOnThreads.name
    val budget = RendererConformance::rule_8_1_promiseToStayWithinTheBudgetIsKept.name
    val heap = RendererConformance::rule_8_1_heapStaysWithinTheBudget.name
    val tidy = RendererConformance::rule_7_9_renderingsLeaveNothingBehind.name
    val leaks = RendererConformance::rule_7_9_renderingsHoldNoMoreMemory.name
    val nested = RendererConformance::rule_7_8_sinkMayRender.name
    val equal = RendererConformance::rule_9_4_equalPrimitivesAreDrawnSeparately.name
    val rounded = RendererConformance::rule_5_5_sumsAreRoundedAsDefined.name
    val depths = RendererConformance::rule_8_1_depthsThatAreAskedForAreCounted.name
    val held = RendererConformance::rule_8_1_peakBytesAreWhatIsHeld.name
    val sizes = RendererConformance::rule_7_1_framesOfManySizesAreIndependent.name
    val emptyRows = RendererConformance::rule_7_8_sinkMayOverwriteEmptyRows.name
    val covered = RendererConformance::rule_2_2_wideTrianglesHideOnlyWhatTheyCover.name
    val wall = RendererConformance::rule_5_1_trianglesCloseToAWallAreDrawnCorrectly.name
    val oneShader = RendererConformance::rule_6_2_surfacesOfOneShaderHaveTheirOwnAttributes.name
    val notInterrupted = RendererConformance::rule_7_9_threadsOfAnExecutorAreNotLeftInterrupted.name
    val manyTiles = RendererConformance::rule_1_1_thousandsOfTilesAreDrawnCorrectly.name
    val counted = RendererConformance::rule_7_10_primitivesOneByOneAreCounted.name
    val streamed = RendererConformance::rule_7_5_streamedFramesGiveTheSamePicture.name
    val millionOfARow = RendererConformance::rule_5_1_nearestOfAMillionFragmentsOfARowIsVisible.name
    val arrivals = RendererConformance::rule_8_1_promiseToStreamPrimitivesIsKept.name

    /** Rules that notice what happens where threads meet, which depends on chance. */
    val chancy: Set<String> = setOf(
        lost, lostCounts, workers, late, halfDone, finish, meets, caller, threads,
    )
}
