package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.alone
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.dazzling
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.oracle.ExpectedSteps
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.DepthWitness
import dev.lazyz.conformance.probes.ShadingWitness
import dev.lazyz.conformance.probes.memory.holdsWhatItReports
import java.util.Random
import net.jqwik.api.ForAll

/**
 * Rules about counters: they count what happens, and have the same meaning for all renderers. Part of
 * `RendererConformance`.
 */
public sealed interface CounterRules : RulesForOne {
    /** All submitted primitives are counted, even those that cover nothing, and all shading calls made are counted. */
    @Rule(
        intent = "The counters equal the number of primitives submitted and the number of shading calls made.",
        look = "Count exactly where Primitive.shade is called, and add up the counters of all threads.",
        about = [Symptom.COUNTERS],
    )
    public fun rule_8_1_countersEqualTheObservedCalls(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val witness = ShadingWitness(case.frame)
        val judgement = Judgement(renderer(), case.watched(witness.frame))
        val counters = judgement.rendering.counters
        val primitives = case.frame.primitives.size.toLong()

        // Only the frame itself has meshes, whose triangles need not be primitives before they are looked at
        for (each in listOf(judgement, Judgement(renderer(), case))) {
            val counted = each.rendering.counters.primitives
            if (counted != primitives) each.fail("$primitives primitives were submitted, but $counted are counted")
        }
        if (counters.shadingCalls != witness.count) {
            judgement.fail("${witness.count} shading calls were made, but ${counters.shadingCalls} are counted")
        }
    }

    /** Fragments are the covered samples, except hidden ones that are rejected before their samples are determined. */
    @Rule(
        intent = "Fragments are the covered samples of each primitive, summed; only hidden ones may be missing.",
        look = "Count where spans are read. Whole rows or tiles are easily missed, and parts outside the region " +
            "counted.",
    )
    public fun rule_8_1_fragmentsEqualTheCoveredSamples(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Int,
    ) {
        val renderer = renderer()
        for (each in listOf(case, case.withinAny(Random(salt.toLong())))) fragmentsAreCovered(renderer, each, salt)
    }

    private fun fragmentsAreCovered(renderer: Renderer, case: FrameCase, salt: Int) {
        val reference = Recording.of(ReferenceRenderer(), case.frame)
        val covered = reference.image.counters.fragments
        val visible = reference.image.visible

        // Renderers that blend count each fragment once, however many layers they search for
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        if (isBlending) countedAtMost(covered, Judgement(renderer, case.glazed(salt)))
        val judgement = Judgement(renderer, case)
        val counted = countedAtMost(covered, judgement)
        if (counted < visible) judgement.fail("$visible samples are visible, but only $counted fragments are counted")

        // A single primitive in front of a background that hides nothing cannot be rejected
        val raster = case.frame.raster
        if (raster.depthTest != raster.convention.nearest || raster.backgroundDepth != raster.convention.farthest) {
            return
        }
        for (index in case.frame.primitives.indices.take(MOST_ALONE)) {
            val alone = case.alone(index)
            val all = Recording.of(ReferenceRenderer(), alone.frame).counters.fragments
            val itself = Judgement(renderer, alone)
            val found = itself.rendering.counters.fragments
            if (found != all) itself.fail("$all samples are covered, but $found fragments are counted")
        }
    }

    /** At most all fragments pass, and at most all wait; where nothing is covered no depth is computed. */
    @Rule(
        intent = "A fragment passes at most once, and where nothing is covered there is no depth to compute.",
        look = "Count a pass where a fragment wins the depth comparison, not where it is looked up later.",
    )
    public fun rule_8_1_passesAreAtMostTheFragments(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val counters = judgement.rendering.counters
        val covered = Recording.of(ReferenceRenderer(), case.frame).counters.fragments
        if (counters.depthPasses > covered) {
            judgement.fail("$covered samples are covered, but ${counters.depthPasses} depth passes are counted")
        }
        if (counters.peakSuspensions !in 0..covered) {
            judgement.fail("$covered samples are covered, but ${counters.peakSuspensions} peak suspensions are counted")
        }
        if (counters.depthEvaluations < 0 || (covered == 0L && counters.depthEvaluations != 0L)) {
            judgement.fail("$covered samples are covered, but ${counters.depthEvaluations} depths are computed")
        }
    }

    /** Starts and steps are counted when they happen, and direct shading never steps. */
    @Rule(
        intent = "A renderer with COHERENCE counts its starts and steps; with DIRECT it never steps.",
        look = "A start is a call of Primitive.shade or a new ShadingCursor. Each ShadingCursor.step is a step, also " +
            "across gaps. The longest chain is the greatest number of steps between two calls of a cursor.",
        tries = 50,
    )
    public fun rule_8_1_startsAndStepsAreCounted(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer(Capability.COHERENCE)
        for (coherence in Coherence.entries) {
            val witness = ShadingWitness(case.frame)
            val configured = renderer.configured(RenderOptions(coherence, threads = 1))
            val judgement = Judgement(configured, case.watched(witness.frame), "$coherence")
            val counters = judgement.rendering.counters
            if (counters.shadingStarts != witness.starts || counters.shadingSteps != witness.steps) {
                judgement.fail("${witness.starts} starts, ${witness.steps} steps are made; the counters are $counters")
            }
            if (coherence == Coherence.DIRECT && witness.steps + counters.longestChain > 0) {
                judgement.fail("shading steps although it is DIRECT: $counters")
            }
            if (counters.longestChain != witness.longestChain) {
                judgement.fail("the longest chain is ${witness.longestChain} steps, but the counters are $counters")
            }
        }
    }

    /** Shading steps from sample to sample exactly where the options request it. */
    @Rule(
        intent =
        "A renderer with COHERENCE steps along rows as its latest options request: INCREMENTAL across all gaps, " +
            "ADAPTIVE across gaps of at most shadingStartCost columns. So do the layers of blended samples.",
        look = "A gap equal to shadingStartCost is stepped across; check also which options configured() keeps.",
        tries = 50,
    )
    public fun rule_8_1_shadingStepsFollowTheOptions(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Int,
    ) {
        val renderer = renderer(Capability.COHERENCE, Capability.SHADES_ONLY_VISIBLE)
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        var last = renderer
        for (each in listOfNotNull(case.asOpaque(), case.glazed(salt).takeIf { isBlending })) {
            for (coherence in listOf(Coherence.INCREMENTAL, Coherence.ADAPTIVE, Coherence.DIRECT)) {
                // Each renderer is configured from the previous one, whose options must not remain
                last = last.configured(RenderOptions(coherence, threads = 1, tileSize = 512))
                stepsAsExpected(last, each, coherence, "$coherence")
            }
        }
        if (Capability.SELECTION !in renderer.capabilities) return
        val nearest = RenderOptions(Coherence.INCREMENTAL, threads = 1, tileSize = 512, selector = Selector.nearest())
        stepsAsExpected(renderer.configured(nearest), case.asOpaque(), nearest.coherence, "a selector of the nearest")
    }

    private fun stepsAsExpected(renderer: Renderer, case: FrameCase, coherence: Coherence, how: String) {
        val witness = ShadingWitness(case.frame)
        val judgement = Judgement(renderer, case.watched(witness.frame), how)
        val starts = judgement.rendering.run { witness.starts }
        val steps = witness.steps
        val expected = ExpectedSteps.of(case.frame, coherence)
        if (starts != expected.starts || steps != expected.steps) {
            judgement.fail("$expected are expected, but $starts starts and $steps steps were made")
        }

        // Renderers may have other code for the library's own primitives, which are hidden by a witness
        val plain = Judgement(renderer, case, how)
        val counters = plain.rendering.counters
        if (counters.shadingStarts != expected.starts || counters.shadingSteps != expected.steps) {
            plain.fail("$expected are expected, but the counters are $counters")
        }
    }

    /** According to the counters, each visible sample has passed and been shaded at least once. */
    @Rule(
        intent = "Shading calls and depth passes are at least the number of visible samples.",
        look = "Look for samples that are decided without being counted: whole blocks, runs, the last remaining " +
            "fragment.",
    )
    public fun rule_8_2_visibleSamplesPassTheTestAndAreShaded(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val visible = judgement.rendering.image.visible
        val counters = judgement.rendering.counters
        if (counters.shadingCalls < visible || counters.depthPasses < visible) {
            judgement.fail("$visible samples are visible, but the counters are $counters")
        }
    }

    /** Each depth that a primitive computes is counted. */
    @Rule(
        intent = "Depths that a primitive computes are an essential part of the cost, so each is counted.",
        look = "Count each call of Primitive.depth; steps along a linear form are counted, too.",
        about = [Symptom.COUNTERS], tries = 30,
    )
    public fun rule_8_1_depthsThatAreAskedForAreCounted(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val witness = DepthWitness(case.frame)
        val counted = renderer.inTime(witness.frame) { _, _, _, _ -> }.depthEvaluations
        val happened = witness.count
        if (counted < happened) {
            Judgement(renderer, case).fail("$happened depths are computed by primitives, but $counted are counted")
        }
    }

    /** Much more than the reported memory is never held, with translucent primitives or a selector, too. */
    @Rule(
        intent = "Peak bytes are what a picture takes, so that users can choose a renderer, and a size, by them.",
        look = "Count each array when it is allocated, and add up what all threads hold at the same time.",
        isSpecial = true,
    )
    public fun rule_8_1_peakBytesAreWhatIsHeld() {
        holdsWhatItReports(renderer())
    }

    /** A renderer that shows something reports how much memory it used. */
    @Rule(
        level = Level.SHOULD,
        intent = "Users choose a renderer by its cost, so a renderer reports its working memory.",
        look = "Add up the arrays that are held at the same time, and set Counters.peakBytes to the greatest sum.",
        tries = 50,
    )
    public fun rule_8_3_workingMemoryIsReported(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val isSeen = judgement.rendering.image.visible > 0
        if (isSeen && judgement.rendering.counters.peakBytes <= 0) {
            judgement.fail("a primitive is visible, but peakBytes is ${judgement.rendering.counters.peakBytes}")
        }
    }

    /** A renderer that declares `SHADES_ONLY_VISIBLE` shades only visible samples. */
    @Rule(
        intent = "A renderer with SHADES_ONLY_VISIBLE shades each visible sample once, and nothing else.",
        look = "Shade after all fragments of a sample have been compared; look for samples that are shaded twice.",
    )
    public fun rule_8_2_promiseToShadeOnlyTheVisibleIsKept(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer(Capability.SHADES_ONLY_VISIBLE)
        val random = Random(salt)
        val part = if (random.nextBoolean()) case.withinAny(random) else case
        val witness = ShadingWitness(part.frame)
        val judgement = Judgement(renderer, part.watched(witness.frame))
        val visible = judgement.rendering.image.visible.toLong()
        val calls = judgement.rendering.counters.shadingCalls
        if (calls != visible) judgement.fail("$visible samples are visible, but $calls shading calls are counted")
        if (witness.count > visible) judgement.fail("$visible samples are visible, but ${witness.count} were shaded")
    }

    /** Where something is blended, a renderer with the capability shades only the fragments that show through. */
    @Rule(
        intent = "When it blends, a renderer with SHADES_ONLY_VISIBLE shades only the fragments that show through.",
        look = "Stop at the first opaque fragment and at transmittance 0, and shade a fragment only when it is " +
            "blended.",
        about = [Symptom.COUNTERS], tries = 60,
    )
    public fun rule_8_2_blendedFragmentsAreShadedOnlyIfVisible(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer(Capability.TRANSPARENCY, Capability.SHADES_ONLY_VISIBLE)
        for (each in listOf(case, case.dazzling(), case.withinAny(Random(salt)))) {
            val showing = Recording.of(ReferenceRenderer(), each.frame).counters.shadingCalls
            val witness = ShadingWitness(each.frame)
            val judgement = Judgement(renderer, each.watched(witness.frame))
            val calls = judgement.rendering.counters.shadingCalls
            if (calls != showing) judgement.fail("$showing fragments show through, but $calls are counted as shaded")
            if (witness.count > showing) {
                judgement.fail("$showing fragments show through, but ${witness.count} were shaded")
            }
        }
    }

    /** Returns how many fragments are counted; fails if they are more than the [covered] samples. */
    private fun countedAtMost(covered: Long, judgement: Judgement): Long {
        val counted = judgement.rendering.counters.fragments
        if (counted > covered) judgement.fail("$covered samples are covered, but $counted fragments are counted")
        return counted
    }

    private companion object {
        /** Greatest number of primitives of a frame that are also rendered alone. */
        const val MOST_ALONE = 4
    }
}
