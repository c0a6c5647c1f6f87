package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.alone
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.dazzling
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Rendering
import dev.lazyz.conformance.judgement.requireDeclared
import dev.lazyz.conformance.oracle.ExpectedSteps
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.ShadingWitness
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about counters: they count what happens, and mean the same for all. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface CounterRules : RulesForOne {
    /** Primitives are counted whether they cover anything or not, and shading calls are the calls that happen. */
    @Rule(
        intent = "Primitives and shading calls are counted as they are submitted and made.",
        look = "Count where Primitive.shade is called, nowhere else, and add up the counters of all threads.",
        about = [Symptom.COUNTERS],
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_countersCountWhatHappens(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val witness = ShadingWitness(case.frame)
        val judgement = Judgement(renderer(), case.watched(witness.frame))
        val counters = judgement.rendering.counters
        val primitives = case.frame.primitives.size.toLong()
        if (counters.primitives != primitives) {
            judgement.fail("$primitives primitives are submitted, ${counters.primitives} counted")
        }
        if (counters.shadingCalls != witness.count) {
            judgement.fail("${witness.count} shading calls are made, ${counters.shadingCalls} counted")
        }
    }

    /** Fragments are the covered samples, but for what is hidden and rejected before its samples are looked for. */
    @Rule(
        intent = "Fragments are covered samples, counted for each primitive; of what is hidden some may be missing.",
        look = "Count where spans are read. What is not in the region, and whole rows or tiles, are easily lost.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_fragmentsAreTheCoveredSamples(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Int,
    ) {
        val reference = Rendering.of(ReferenceRenderer(), case.frame)
        val covered = reference.image.counters.fragments
        val visible = reference.image.visible
        val renderer = renderer()

        // Who blends counts each fragment once, however many layers it looks for
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        if (isBlending) countedAtMost(covered, Judgement(renderer, case.glazed(salt)))
        val judgement = Judgement(renderer, case)
        val counted = countedAtMost(covered, judgement)
        if (counted < visible) judgement.fail("$visible samples show something, $counted fragments counted")

        // A primitive by itself, before a background that hides nothing, has nothing to be rejected for
        val raster = case.frame.raster
        if (raster.depthTest != raster.convention.nearest ||
            raster.backgroundDepth != raster.convention.farthest
        ) {
            return
        }
        for (index in case.frame.primitives.indices.take(MOST_ALONE)) {
            val alone = case.alone(index)
            val all = Rendering.of(ReferenceRenderer(), alone.frame).counters.fragments
            val itself = Judgement(renderer, alone)
            val found = itself.rendering.counters.fragments
            if (found != all) itself.fail("$all samples are covered, $found fragments counted")
        }
    }

    /** Of the fragments no more pass than there are, and where there are none nothing is computed. */
    @Rule(
        intent = "A fragment passes at most once, and where nothing is covered there is no depth to compute.",
        look = "Count a pass where a fragment is the visible one when it is compared, not where it is looked up.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_passesAreAmongTheFragments(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val counters = judgement.rendering.counters
        val covered = Rendering.of(ReferenceRenderer(), case.frame).counters.fragments
        if (counters.depthPasses > covered) {
            judgement.fail("$covered samples are covered, ${counters.depthPasses} passes counted")
        }
        if (counters.depthEvaluations < 0 || (covered == 0L && counters.depthEvaluations != 0L)) {
            judgement.fail("$covered samples are covered, ${counters.depthEvaluations} depths are computed")
        }
    }

    /** Starts and steps are counted as they happen, and direct shading never steps. */
    @Rule(
        intent = "Who shades late says how often it starts and how often it steps; DIRECT never steps.",
        look = "A start is Primitive.shade or a new ShadingCursor; each ShadingCursor.step is a step, over gaps too. " +
            "The longest chain is the most steps from one call of a cursor to its next.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_startsAndStepsAreCounted(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.COHERENCE)
        for (coherence in Coherence.entries) {
            val witness = ShadingWitness(case.frame)
            val configured = renderer.configured(RenderOptions(coherence, threads = 1))
            val judgement = Judgement(configured, case.watched(witness.frame), "$coherence")
            val counters = judgement.rendering.counters
            if (counters.shadingStarts != witness.starts || counters.shadingSteps != witness.steps) {
                judgement.fail("${witness.starts} starts, ${witness.steps} steps are made, the counters are $counters")
            }
            if (coherence == Coherence.DIRECT && witness.steps + counters.longestChain > 0) {
                judgement.fail("direct shading steps: $counters")
            }
            if (counters.longestChain != witness.longestChain) {
                judgement.fail("a call needs ${witness.longestChain} steps at most, the counters are $counters")
            }
        }
    }

    /** Shading steps from sample to sample where the options say so, and nowhere else. */
    @Rule(
        intent =
        "Who promises COHERENCE steps along rows as the options say, the latest ones: INCREMENTAL over all gaps, " +
            "ADAPTIVE over those of at most shadingStartCost columns.",
        look = "Compare gaps with shadingStartCost, equal ones are stepped over; look at what configured() keeps.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_shadingStepsAsTheOptionsSay(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.COHERENCE)
        requireDeclared(renderer, Capability.SHADES_ONLY_VISIBLE)
        val opaque = case.asOpaque()
        var last = renderer
        for (coherence in listOf(Coherence.INCREMENTAL, Coherence.ADAPTIVE, Coherence.DIRECT)) {
            // Each is configured from the one before, whose options must not be left
            val configured = last.configured(RenderOptions(coherence, threads = 1, tileSize = 512))
            last = configured
            val witness = ShadingWitness(opaque.frame)
            val judgement = Judgement(configured, opaque.watched(witness.frame), "$coherence")
            val starts = judgement.rendering.run { witness.starts }
            val steps = witness.steps
            val right = Rendering.of(ReferenceRenderer(), opaque.frame).image
            val expected = ExpectedSteps.of(opaque.frame, right, coherence)
            if (starts == expected.starts && steps == expected.steps) continue
            judgement.fail("$expected are needed, $starts starts and $steps steps are made")
        }
    }

    /** Whatever is visible has passed and been shaded at least once, by the counters. */
    @Rule(
        intent = "Shading calls and passes are at least the visible samples.",
        look = "Look for samples that are decided without being counted: whole blocks, runs, the last fragment left.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_2_visibleSamplesArePassedAndShaded(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val visible = judgement.rendering.image.visible
        val counters = judgement.rendering.counters
        if (counters.shadingCalls < visible || counters.depthPasses < visible) {
            judgement.fail("$visible samples are visible, but the counters are $counters")
        }
    }

    /** Who shows something says how much memory that took. */
    @Rule(
        level = Level.SHOULD,
        intent = "Users choose a renderer by what it costs, so it tells its working memory.",
        look = "Add up the arrays that are held at the same time, and set Counters.peakBytes to the greatest sum.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_3_workingMemoryIsReported(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val judgement = Judgement(renderer(), case)
        val isSeen = judgement.rendering.image.visible > 0
        if (isSeen && judgement.rendering.counters.peakBytes <= 0) {
            judgement.fail("something is visible, but peakBytes is ${judgement.rendering.counters.peakBytes}")
        }
    }

    /** A renderer that promises to shade only what is visible does so. */
    @Rule(
        intent = "Who promises SHADES_ONLY_VISIBLE shades each visible sample once, and nothing else.",
        look = "Shade when all fragments of a sample have been compared; look for samples that are shaded twice.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_2_promiseToShadeOnlyTheVisibleIsKept(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.SHADES_ONLY_VISIBLE)
        val witness = ShadingWitness(case.frame)
        val judgement = Judgement(renderer, case.watched(witness.frame))
        val visible = judgement.rendering.image.visible.toLong()
        val calls = judgement.rendering.counters.shadingCalls
        if (calls != visible) judgement.fail("$visible samples are visible, but $calls are shaded")
        if (witness.count > visible) judgement.fail("$visible samples are visible, but ${witness.count} were shaded")
    }

    /** Where something is blended, a renderer with the promise shades what shows through, and nothing else. */
    @Rule(
        intent = "Who promises SHADES_ONLY_VISIBLE shades, of what it blends, the fragments that show through.",
        look = "Stop at the first opaque fragment and at transmittance 0, and shade a fragment when it is its turn.",
        about = [Symptom.COUNTERS],
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_2_whatIsBlendedIsShadedOnlyIfItShows(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.TRANSPARENCY)
        requireDeclared(renderer, Capability.SHADES_ONLY_VISIBLE)
        for (each in listOf(case, case.dazzling())) {
            val showing = Rendering.of(ReferenceRenderer(), each.frame).counters.shadingCalls
            val witness = ShadingWitness(each.frame)
            val judgement = Judgement(renderer, each.watched(witness.frame))
            val calls = judgement.rendering.counters.shadingCalls
            if (calls != showing) judgement.fail("$showing fragments show, but $calls are shaded")
            if (witness.count > showing) judgement.fail("$showing fragments show, but ${witness.count} were shaded")
        }
    }

    /** Returns how many fragments are counted, which are no more than the [covered] samples. */
    private fun countedAtMost(covered: Long, judgement: Judgement): Long {
        val counted = judgement.rendering.counters.fragments
        if (counted > covered) judgement.fail("$covered samples are covered, $counted fragments counted")
        return counted
    }

    private companion object {
        /** Primitives of a frame that are also rendered by themselves. */
        const val MOST_ALONE = 4
    }
}
