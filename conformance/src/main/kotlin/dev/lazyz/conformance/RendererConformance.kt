package dev.lazyz.conformance

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.lifecycle.AddLifecycleHook
import net.jqwik.api.lifecycle.PropagationMode

/**
 * The suite that every renderer must pass: extend it in a test, say which renderer, and run it with jqwik.
 *
 * Every test is a rule of `docs/contract.md` and carries its number. Frames are random but the same at every run; one
 * that fails is shrunk, and printed as the code that makes it, with the first sample that differs and both answers.
 *
 * The system property [TRIES] multiplies the number of frames (`-Dlazyz.conformance.tries=100` for a night, `0.1` while
 * debugging), and [SEED] chooses others. Cost: a few seconds for a renderer, in one thread but for one rule.
 */
@Suppress("ktlint:standard:function-naming")
@AddLifecycleHook(value = Effort::class, propagateTo = PropagationMode.ALL_DESCENDANTS)
public abstract class RendererConformance {
    /** Returns the renderer to judge, a new one or always the same. Called once for each try of each rule. */
    public abstract fun renderer(): Renderer

    /** Frames of [Confetti]: many spans a row, loose bounds, and depth that is no linear form. */
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_2_8_primitivesOfOnesOwnCoverWhatTheySay(@ForAll(supplier = ConfettiCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** The background competes with its own depth, wherever that lies, and keeps its colour where it wins. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_4_3_backgroundIsWhereNothingPasses(@ForAll(supplier = ScreenCases::class) case: FrameCase) {
        // Put the background before everything, behind everything, and where something is
        val visible = Rendering.of(ReferenceRenderer(), case.frame).image.depth
        for (depth in listOf(0, Int.MAX_VALUE, visible[visible.size / 2])) {
            val raster = with(case.frame.raster) { Raster(width, height, background, convention, depthTest, depth) }
            Judgement(renderer(), case.on(raster)).equalsReference()
        }
    }

    /** Colours, depths and primitives of frames on the screen are the oracle's. */
    @Property(tries = 500, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_nearestFragmentIsVisible(@ForAll(supplier = ScreenCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Colours, depths and primitives of scenes are the oracle's. */
    @Property(tries = 250, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_nearestFragmentIsVisibleInScenes(@ForAll(supplier = WorldCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** The pictures of two halves of the primitives, merged, are the picture of all. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_partsMergeIntoTheWhole(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val even = Judgement(renderer, case.keeping(0)).equalsReference().rendering.image
        val odd = Judgement(renderer, case.keeping(1)).equalsReference().rendering.image
        val whole = Judgement(renderer, case)
        difference(Image.merge(even, odd, case.frame.raster), whole.rendering.image)?.let { whole.fail("merged: $it") }
    }

    /** Where depths are equal, the order of submission decides. */
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_2_tiesGoToTheFirstSubmitted(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val usual = with(case.frame.raster) { Raster(width, height, background) }
        Judgement(renderer(), case.on(usual)).equalsReference()
    }

    /** All depth tests, under both conventions, decide as they are defined, ties included. */
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_3_everyDepthTestIsObeyed(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        for (test in DepthTest.entries) {
            val behind = Frames.behindAll(test)
            for (convention in DepthConvention.entries) {
                val raster = with(case.frame.raster) { Raster(width, height, background, convention, test, behind) }
                Judgement(renderer(), case.on(raster)).equalsReference()
            }
        }
    }

    /** In another order the same is visible, except where two primitives have the same, winning depth. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_4_orderIsIrrelevantWithoutTies(
        @ForAll(supplier = ScreenCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val order = case.frame.primitives.indices.shuffled(Random(salt))
        val first = Judgement(renderer, case).rendering.image
        val reordered = Judgement(renderer, case.inOrder(order))
        val second = reordered.rendering.image
        for (sample in first.primitive.indices) {
            val x = sample % first.width
            val y = sample / first.width
            val a = first.primitive[sample]
            val b = second.primitive[sample].let { order.getOrElse(it) { DepthTest.BACKGROUND } }
            val isSame =
                a == b && first.depth[sample] == second.depth[sample] && first.argb[sample] == second.argb[sample]
            if (isSame || (a != b && case.frame.isTie(a, b, x, y))) continue
            reordered.fail("sample ($x, $y) showed primitive $a, shows $b where the order of submission is $order")
        }
    }

    /** A renderer that promises transparency blends in exact order of depth. */
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_5_translucentPrimitivesBlendInOrderOfDepth(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY in renderer.capabilities) Judgement(renderer, case).equalsReference().rowsInOrder()
    }

    /** A renderer that does not promise transparency refuses a translucent primitive before it hands out a row. */
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_6_whoCannotBlendRefuses(@ForAll(supplier = TranslucentCases::class) case: FrameCase) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY !in renderer.capabilities && case.frame.hasTranslucency) refused(renderer, case)
        Judgement(renderer, case.asOpaque()).equalsReference()
    }

    /** A renderer that renders a frame again after others gives the same bits, by rows and into memory. */
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_sameBitsAgain(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val renderer = renderer()
        for (case in cases + cases) Judgement(renderer, case).equalsReference().equalsItsImage()
    }

    /** A renderer that several threads use at once, each for another frame, gives the same bits. */
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_sameBitsFromSeveralThreads(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val renderer = renderer()
        atOnce(cases) { case -> repeat(3) { Judgement(renderer, case).equalsReference() } }
    }

    /** Rows arrive from the top to the bottom, each once. */
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_rowsArriveInOrderEachOnce(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case).rowsInOrder()
    }

    /** Part of a raster is rendered as that part of the whole picture, and nothing else is. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_4_regionIsThatPartOfThePicture(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val raster = case.frame.raster
        val random = Random(salt)
        val columnStart = random.nextInt(raster.width)
        val rowStart = random.nextInt(raster.height)
        val columnEnd = columnStart + 1 + random.nextInt(raster.width - columnStart)
        val rowEnd = rowStart + 1 + random.nextInt(raster.height - rowStart)
        val part = case.within(Region(columnStart, rowStart, columnEnd, rowEnd))
        Judgement(renderer(), part).equalsReference().equalsItsImage().rowsInOrder()
    }

    /** Options change what a rendering costs, and never its picture. */
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_5_optionsChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        for (coherence in Coherence.entries) {
            for (budget in listOf(null, 0L, 1000L)) {
                val threads = if (budget == null) 3 else 1
                val options = RenderOptions(coherence, budget, threads, tileSize = 8)
                Judgement(renderer().configured(options), case, "$options").equalsReference()
            }
        }
    }

    /** Primitives are counted whether they cover anything or not, and shading calls are the calls that happen. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_countersCountWhatHappens(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val witness = ShadingWitness(case.frame)
        val judgement = Judgement(renderer(), FrameCase(witness.frame, case.code))
        val counters = judgement.rendering.counters
        val primitives = case.frame.primitives.size.toLong()
        if (counters.primitives != primitives) {
            judgement.fail("$primitives primitives are submitted, ${counters.primitives} counted")
        }
        if (counters.shadingCalls != witness.count) {
            judgement.fail("${witness.count} shading calls are made, ${counters.shadingCalls} counted")
        }
    }

    /** Whatever is visible has passed and been shaded at least once, by the counters. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_2_visibleSamplesArePassedAndShaded(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val visible = judgement.rendering.image.visible
        val counters = judgement.rendering.counters
        if (counters.shadingCalls < visible || counters.depthPasses < visible) {
            judgement.fail("$visible samples are visible, but the counters are $counters")
        }
    }

    /** A renderer that promises to shade only what is visible does so. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_2_promiseToShadeOnlyTheVisibleIsKept(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        if (Capability.SHADES_ONLY_VISIBLE !in renderer.capabilities) return
        val judgement = Judgement(renderer, case)
        val visible = judgement.rendering.image.visible
        val calls = judgement.rendering.counters.shadingCalls
        if (calls != visible.toLong()) judgement.fail("$visible samples are visible, but $calls are shaded")
    }

    /** Primitives that cover nothing, submitted between the others, change indices and nothing else. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_4_primitivesThatCoverNothingKeepTheirIndex(
        @ForAll(supplier = ScreenCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case.padded()).equalsReference()
    }

    /** Frames without primitives show the background, and cost nothing. */
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_6_framesWithoutPrimitivesAreOrdinary(@ForAll(supplier = EmptyCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case).equalsReference()
        val counters = judgement.rendering.counters
        if (counters.fragments != 0L || counters.shadingCalls != 0L) {
            judgement.fail("nothing was submitted, but the counters are $counters")
        }
    }

    /** Rasters of one sample, one row or one column are rendered like others. */
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_6_narrowRastersAreOrdinary(@ForAll(supplier = NarrowCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    public companion object {
        /** System property: a positive decimal number that multiplies the number of frames each rule is tried on. */
        public const val TRIES: String = "lazyz.conformance.tries"

        /** System property: a whole number that replaces the fixed seed of all rules. */
        public const val SEED: String = "lazyz.conformance.seed"

        private const val FIXED = "1995"
    }
}
