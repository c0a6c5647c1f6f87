package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.conformance.cases.ALL_GLASS
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.Unbounded
import dev.lazyz.conformance.cases.changed.alike
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.behindMany
import dev.lazyz.conformance.cases.changed.on
import dev.lazyz.conformance.cases.changed.padded
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.cases.changed.withHiddenGlass
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.ConfettiCases
import dev.lazyz.conformance.frames.EmptyCases
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.NarrowCases
import dev.lazyz.conformance.frames.ScreenCases
import dev.lazyz.conformance.frames.TiedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.frames.WorldCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.NotDeclared
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.refused
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.fewTriangles
import dev.lazyz.conformance.probes.smallWorlds
import java.util.Random
import net.jqwik.api.ForAll

/** Rules about the picture: it equals the oracle's picture, bit for bit. Part of `RendererConformance`. */
public sealed interface PictureRules : RulesForOne {
    /** Frames of [Confetti]: many spans in a row, loose bounds, and depth without a linear form. */
    @Rule(
        intent = "Custom primitives cover their spans: many spans in a row, loose bounds, depth without a linear form.",
        look = "Look for code that assumes one span per row, tight bounds, or a depthForm that is not null.",
        about = [Symptom.OWN_PRIMITIVE], tries = 200,
    )
    public fun rule_2_8_customPrimitivesCoverTheirSpans(@ForAll(supplier = ConfettiCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Custom primitives whose bounds say nothing. */
    @Rule(
        intent = "Bounds only limit where a custom primitive may cover samples; they can be larger than any raster.",
        look = "Look for differences of bounds that overflow, and limit bounds to the region before you count tiles.",
        about = [Symptom.OWN_PRIMITIVE],
        isSpecial = true, tries = 40,
    )
    public fun rule_2_8_boundsMayBeLargerThanTheRaster(@ForAll(supplier = ConfettiCases::class) case: FrameCase) {
        val unbounded = with(case.frame) { Frame(raster, primitives.map(::Unbounded), region) }
        Judgement(renderer(), case.watched(unbounded), "bounds of 2^30 columns and rows").equalsReference()
    }

    /**
     * The background takes part in the depth test with its own depth, at any depth, and keeps its colour where it wins.
     */
    @Rule(
        intent = "The background takes part in the depth test with its own depth, as if it were submitted first.",
        look = "Initialise each sample with Raster.backgroundDepth, and compare it like any other fragment.",
        about = [Symptom.BACKGROUND],
    )
    public fun rule_4_3_backgroundIsVisibleWhereNoFragmentPasses(
        @ForAll(supplier = ScreenCases::class) onScreen: FrameCase,
        @ForAll(supplier = WorldCases::class) world: FrameCase,
    ) {
        // Put the background in front of everything, behind everything, and at the depth of a visible sample
        for (case in listOf(onScreen, world)) {
            val visible = Recording.of(ReferenceRenderer(), case.frame).image.depth
            for (depth in listOf(0, Int.MAX_VALUE, visible[visible.size / 2])) {
                val raster = case.frame.raster.withBackgroundDepth(depth)
                Judgement(renderer(), case.on(raster)).equalsReference()
            }
        }
    }

    /** Colours, depths and primitives of frames in screen space equal those of the oracle. */
    @Rule(
        intent = "The visible fragment of a sample is the minimum by (depth, submission index), exactly.",
        look = "Check the sample that differs: is it covered, is its depth exact, is it compared with all others?",
        about = [Symptom.PICTURE], tries = 500,
    )
    public fun rule_5_1_nearestFragmentIsVisible(@ForAll(supplier = ScreenCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Colours, depths and primitives of 3D scenes equal those of the oracle. */
    @Rule(
        intent = "Meshes, polygons and spheres seen through a camera, clipped and masked, show the nearest surface.",
        look =
        "If frames in screen space pass, check spheres (no depthForm), masks (many spans), clipped polygons, and " +
            "in which order the triangles of a mesh are drawn.",
        about = [Symptom.IN_SPACE], tries = 250,
    )
    public fun rule_5_1_nearestFragmentIsVisibleInScenes(@ForAll(supplier = WorldCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Where depths are equal, the order of submission decides. */
    @Rule(
        intent = "Equal depths are decided by the order of submission, regardless of the order of evaluation.",
        look = "Compare DepthTest.key or the pair (depth, index); comparing only depths with < or <= is not enough.",
        about = [Symptom.TIE], tries = 200,
    )
    public fun rule_5_2_tiesGoToTheFirstSubmitted(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val usual = case.frame.raster.withConvention(DepthConvention.SMALLER_IS_NEARER)
        Judgement(renderer(), case.on(usual)).equalsReference()
    }

    /** All depth tests work as defined under both conventions, including ties. */
    @Rule(
        intent = "All four depth tests are total orders, under either convention.",
        look = "Take the order from Raster.depthTest alone, not from the convention or from its default test.",
        about = [Symptom.AGAINST_CONVENTION, Symptom.DEPTH_TEST, Symptom.GREATEST_WINS], tries = 50,
    )
    public fun rule_5_3_everyDepthTestIsObeyed(
        @ForAll(supplier = TiedCases::class) tied: FrameCase,
        @ForAll(supplier = MixedCases::class) mixed: FrameCase,
        @ForAll salt: Long,
    ) {
        for (case in listOf(tied, mixed, fewTriangles(salt, Raster(8, 8)))) {
            for (test in DepthTest.entries) {
                for (convention in DepthConvention.entries) {
                    val raster = case.frame.raster.withConvention(convention).withDepthTest(test)

                    // Behind everything, or before everything, so that only what has the same depth can pass
                    for (depth in listOf(0, Int.MAX_VALUE)) {
                        Judgement(renderer(), case.on(raster.withBackgroundDepth(depth))).equalsReference()
                    }
                }
            }
        }
    }

    /** On a raster of 3 x 2 samples, every ordered pair of forty shapes is correct, with every test and convention. */
    @Rule(
        intent = "On a tiny raster, all combinations are tested: every tie, crossing and coincidence.",
        look = "Look at the two primitives of the printed frame: which is nearer, or, at equal depth, which comes " +
            "first?",
    )
    public fun rule_5_3_allPairsOnATinyRasterAreDrawnCorrectly() {
        smallWorlds(renderer())
    }

    /** A renderer that declares transparency blends in exact order of depth. */
    @Rule(
        intent = "A renderer with TRANSPARENCY blends in exact order of depth, with a fixed order of summation.",
        look = "Sort a sample's fragments by key, stop at the first opaque one, and sum up as rule 5.5 defines.",
        about = [Symptom.TRANSLUCENT], tries = 200,
    )
    public fun rule_5_5_translucentPrimitivesBlendInOrderOfDepth(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
    ) {
        val renderer = renderer(Capability.TRANSPARENCY)
        Judgement(renderer, case).equalsReference().rowsInOrder()
    }

    /** A renderer without transparency rejects a translucent primitive before it delivers a row. */
    @Rule(
        intent = "An error is better than a wrong picture without notice.",
        look = "Check Frame.hasTranslucency before the first row, and throw an IllegalArgumentException whose " +
            "message has the primitive's index and the remedy.",
        about = [Symptom.TRANSLUCENT], tries = 50,
    )
    public fun rule_5_6_renderersWithoutTransparencyRefuseTranslucentFrames(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY !in renderer.capabilities && case.frame.hasTranslucency) refused(renderer, case)
        Judgement(renderer, case.asOpaque()).equalsReference()
    }

    /** A translucent primitive is rejected whether it is visible or not. */
    @Rule(
        intent = "Which frames a renderer accepts depends neither on the region nor on what is hidden.",
        look = "Check all primitives of the frame, including those outside the region and those hidden by others.",
        about = [Symptom.TRANSLUCENT], tries = 20,
    )
    public fun rule_5_6_hiddenTranslucentPrimitivesAreRefused(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY in renderer.capabilities) throw NotDeclared("TRANSPARENCY is declared")
        val random = Random(salt)
        for (hiding in case.withinAny(random).withHiddenGlass(random)) refused(renderer, hiding)
    }

    /** Primitives that cover nothing, submitted between the others, change only the indices. */
    @Rule(
        intent = "Indices do not depend on visibility, so that parts of a frame can be merged.",
        look = "Number primitives by their position in Frame.primitives, before discarding any of them.",
        about = [Symptom.EMPTY_PRIMITIVE],
    )
    public fun rule_9_4_primitivesThatCoverNothingKeepTheirIndex(
        @ForAll(supplier = ScreenCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case.padded()).equalsReference()
    }

    /** Primitives that are equal, or the same object, are drawn as different ones. */
    @Rule(
        intent = "A primitive is identified by its index alone: two may be equal, and one may be submitted twice.",
        look = "Look for sets and maps of primitives, for indexOf, and for comparisons of primitives with ==.",
        tries = 60,
    )
    public fun rule_9_4_equalPrimitivesAreDrawnSeparately(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val renderer = renderer()
        Judgement(renderer, case.alike()).equalsReference()
        if (Capability.TRANSPARENCY in renderer.capabilities) {
            Judgement(renderer, case.glazed(MIXED).alike()).equalsReference()
        }
    }

    /** Indices are correct behind and in front of more primitives than 16 bits can number. */
    @Rule(
        intent = "Indices have 31 bits: a frame may have more primitives than a short or a float can represent.",
        look = "Look at the width of the index in a packed key, and at every cast on its way to the row.",
        about = [Symptom.MANY_PRIMITIVES], tries = 8,
    )
    public fun rule_9_4_indicesAreNotTruncated(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val renderer = renderer()
        val many = case.behindMany()
        Judgement(renderer, many).equalsReference()

        // Renderers that blend may store translucent fragments differently
        if (Capability.TRANSPARENCY in renderer.capabilities) {
            Judgement(renderer, many.glazed(ALL_GLASS)).equalsReference()
        }
    }

    /** Frames without primitives show the background and cost nothing. */
    @Rule(
        intent = "An empty frame is valid: it shows the background, and nothing is counted.",
        look = "Look for a first(), a minimum or a division that needs at least one primitive.",
        about = [Symptom.NO_PRIMITIVES], tries = 25,
    )
    public fun rule_9_6_framesWithoutPrimitivesShowTheBackground(
        @ForAll(supplier = EmptyCases::class) case: FrameCase,
    ) {
        val judgement = Judgement(renderer(), case).equalsReference()
        val counters = judgement.rendering.counters
        if (counters.fragments != 0L || counters.shadingCalls != 0L) {
            judgement.fail("no primitive was submitted, but the counters are $counters")
        }
    }

    /** Rasters of one sample, one row or one column are rendered like others. */
    @Rule(
        intent = "Rasters of one sample, one row or one column are valid.",
        look = "Look at sizes that are rounded up to blocks, at differences to the next row, at loops that start at 1.",
        about = [Symptom.NARROW],
    )
    public fun rule_9_6_narrowRastersAreDrawnCorrectly(@ForAll(supplier = NarrowCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    private companion object {
        /** Every other primitive, as the choice of `glazed`. */
        const val MIXED = 0x5555
    }
}
