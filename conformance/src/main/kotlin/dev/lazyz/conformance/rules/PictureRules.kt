package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.behindMany
import dev.lazyz.conformance.cases.changed.on
import dev.lazyz.conformance.cases.changed.padded
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
import dev.lazyz.conformance.judgement.Rendering
import dev.lazyz.conformance.judgement.refused
import dev.lazyz.conformance.judgement.requireDeclared
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.smallWorlds
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about the picture: it is the oracle's, bit for bit. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface PictureRules : RulesForOne {
    /** Frames of [Confetti]: many spans a row, loose bounds, and depth that is no linear form. */
    @Rule(
        intent = "Primitives of one's own cover what they say: many spans a row, loose bounds, depth without a form.",
        look = "Look for places that assume one span a row, close bounds, or a depthForm that is not null.",
        about = [Symptom.OWN_PRIMITIVE],
    )
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_2_8_primitivesOfOnesOwnCoverWhatTheySay(@ForAll(supplier = ConfettiCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** The background competes with its own depth, wherever that lies, and keeps its colour where it wins. */
    @Rule(
        intent = "The background competes with its own depth, wherever that lies, as if it were submitted first.",
        look = "Initialise each sample with Raster.backgroundDepth, and compare with it as with any other fragment.",
        about = [Symptom.BACKGROUND],
    )
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
    @Rule(
        intent = "The visible fragment of a sample is the least by (depth, submission index), exactly.",
        look = "Follow the sample that differs: is it covered, is its depth exact, is it compared with all others?",
        about = [Symptom.PICTURE],
    )
    @Property(tries = 500, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_nearestFragmentIsVisible(@ForAll(supplier = ScreenCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Colours, depths and primitives of scenes are the oracle's. */
    @Rule(
        intent = "Meshes, polygons and spheres before a camera, clipped and masked, show what is nearest.",
        look = "If frames on the screen pass, look at spheres (no depthForm), masks (many spans) and clipped polygons.",
        about = [Symptom.IN_SPACE],
    )
    @Property(tries = 250, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_nearestFragmentIsVisibleInScenes(@ForAll(supplier = WorldCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Where depths are equal, the order of submission decides. */
    @Rule(
        intent = "Equal depths are decided by the order of submission, whatever the order of evaluation.",
        look = "Compare DepthTest.key or the pair (depth, index); a strict or lax comparison of depths is not enough.",
        about = [Symptom.TIE],
    )
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_2_tiesGoToTheFirstSubmitted(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val usual = with(case.frame.raster) { Raster(width, height, background) }
        Judgement(renderer(), case.on(usual)).equalsReference()
    }

    /** All depth tests, under both conventions, decide as they are defined, ties included. */
    @Rule(
        intent = "All four depth tests are total orders, under either convention.",
        look = "Take the order from Raster.depthTest alone: neither the convention nor the usual test says it.",
        about = [Symptom.DEPTH_TEST, Symptom.GREATEST_WINS],
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_3_everyDepthTestIsObeyed(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        for (test in DepthTest.entries) {
            val behind = Rasters.behindAll(test)
            for (convention in DepthConvention.entries) {
                val raster = with(case.frame.raster) { Raster(width, height, background, convention, test, behind) }
                Judgement(renderer(), case.on(raster)).equalsReference()
            }
        }
    }

    /** On a raster of 3 x 2 samples, every ordered pair of forty shapes is right, under every test and convention. */
    @Rule(
        intent = "Within a small bound nothing is left to chance: all ties, crossings and coincidences are tried.",
        look = "The two primitives of the printed frame: which is nearer, or, at equal depth, which comes first.",
    )
    @Property(tries = 1)
    public fun rule_5_3_everyPairInASmallWorldIsRight() {
        smallWorlds(renderer())
    }

    /** A renderer that promises transparency blends in exact order of depth. */
    @Rule(
        intent = "Who promises TRANSPARENCY blends in exact order of depth, with one order of sums.",
        look = "Sort a sample's fragments by key, stop at the first opaque one, and add up as rule 5.5 says.",
        about = [Symptom.TRANSLUCENT],
    )
    @Property(tries = 200, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_5_translucentPrimitivesBlendInOrderOfDepth(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.TRANSPARENCY)
        Judgement(renderer, case).equalsReference().rowsInOrder()
    }

    /** A renderer that does not promise transparency refuses a translucent primitive before it hands out a row. */
    @Rule(
        intent = "A wrong picture without a word would be worse than none.",
        look = "Ask Frame.hasTranslucency before the first row, and throw an IllegalArgumentException that says so.",
        about = [Symptom.TRANSLUCENT],
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_6_whoCannotBlendRefuses(@ForAll(supplier = TranslucentCases::class) case: FrameCase) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY !in renderer.capabilities && case.frame.hasTranslucency) refused(renderer, case)
        Judgement(renderer, case.asOpaque()).equalsReference()
    }

    /** A translucent primitive is refused whether anything of it can be seen or not. */
    @Rule(
        intent = "Which frames a renderer takes does not depend on the region, nor on what hides what.",
        look = "Ask all primitives of the frame, before those are left out that the region or others hide.",
        about = [Symptom.TRANSLUCENT],
    )
    @Property(tries = 20, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_6_hiddenTranslucencyIsRefused(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        if (Capability.TRANSPARENCY in renderer.capabilities) throw NotDeclared("TRANSPARENCY is declared")
        val random = Random(salt)
        for (hiding in case.withinAny(random).withHiddenGlass(random)) refused(renderer, hiding)
    }

    /** Primitives that cover nothing, submitted between the others, change indices and nothing else. */
    @Rule(
        intent = "Numbering does not depend on what can be seen, so parts of a frame can be merged.",
        look = "Number primitives by their place in Frame.primitives, before any of them is thrown away.",
        about = [Symptom.EMPTY_PRIMITIVE],
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_4_primitivesThatCoverNothingKeepTheirIndex(
        @ForAll(supplier = ScreenCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case.padded()).equalsReference()
    }

    /** Behind more primitives than 16 bits can number, and before them, indices are still right. */
    @Rule(
        intent = "Indices have 31 bits: a frame may have more primitives than a short, or a float, can number.",
        look = "Look at the width of the index within a packed key, and at every cast on its way to the row.",
        about = [Symptom.MANY_PRIMITIVES],
    )
    @Property(tries = 8, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_4_indicesAreNotCut(@ForAll(supplier = TiedCases::class) case: FrameCase) {
        val renderer = renderer()
        val many = case.behindMany()
        Judgement(renderer, many).equalsReference()

        // Who blends may keep translucent fragments in another way
        if (Capability.TRANSPARENCY in renderer.capabilities) {
            Judgement(renderer, many.glazed(0xFFFF)).equalsReference()
        }
    }

    /** Frames without primitives show the background, and cost nothing. */
    @Rule(
        intent = "An empty frame is a frame: all background, nothing counted.",
        look = "Look for a first(), a minimum or a division that wants at least one primitive.",
        about = [Symptom.NO_PRIMITIVES],
    )
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_6_framesWithoutPrimitivesAreOrdinary(@ForAll(supplier = EmptyCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case).equalsReference()
        val counters = judgement.rendering.counters
        if (counters.fragments != 0L || counters.shadingCalls != 0L) {
            judgement.fail("nothing was submitted, but the counters are $counters")
        }
    }

    /** Rasters of one sample, one row or one column are rendered like others. */
    @Rule(
        intent = "Rasters of one sample, one row or one column are ordinary.",
        look = "Look at sizes that are rounded to blocks, at differences to a next row, at loops that begin with 1.",
        about = [Symptom.NARROW],
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_6_narrowRastersAreOrdinary(@ForAll(supplier = NarrowCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }
}
