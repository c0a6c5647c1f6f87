package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.requireStreaming
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.OneByOne
import dev.lazyz.conformance.probes.Planted
import dev.lazyz.conformance.probes.Question
import dev.lazyz.conformance.probes.Trap
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.hasEnded
import dev.lazyz.conformance.probes.optionsForStreams
import dev.lazyz.conformance.probes.streamedIsTheSame
import java.util.Random
import net.jqwik.api.ForAll

/**
 * Rules about primitives that arrive one by one or part by part. Most apply only to a [StreamingRenderer]. Part of
 * `RendererConformance`.
 */
public sealed interface StreamingRules : RulesForOne {
    /** Primitives that arrive one by one give the same picture as a frame, also while another is in progress. */
    @Rule(
        intent = "A StreamingRenderer gives the same picture however it gets the primitives, and may draw several " +
            "pictures at the same time.",
        look = "Draw in both ways by the same code, and keep what belongs to a picture in the Rendering. A primitive " +
            "that is refused has no index.",
        tries = 50,
    )
    public fun rule_7_10_primitivesOneByOneGiveTheSamePicture(
        @ForAll(supplier = MixedCases::class) whole: FrameCase,
        @ForAll choice: Int,
    ) {
        val renderer = requireStreaming(renderer())
        val case = if (choice % 2 == 0) whole else whole.withinAny(Random(choice.toLong()))
        Judgement(OneByOne(renderer), case, "primitives one by one").equalsReference().rowsInOrder()

        // With glass, which a renderer that does not blend refuses, and continues without
        val glazed = case.glazed(choice)
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        val accepted = glazed.frame.primitives.filter { isBlending || !it.isTranslucent }
        val expected = Frame(case.frame.raster, accepted, case.frame.region)
        Judgement(OneByOne(renderer), glazed, "primitives one by one, some translucent")
            .equalsPicture(Recording.of(ReferenceRenderer(), expected).image)
    }

    /**
     * All primitives that arrive one by one are counted and have the index of their arrival, although most of them are
     * hidden and need not be kept.
     */
    @Rule(
        intent = "The counter of primitives is the number of those that were added, and an index counts all of them.",
        look = "Count in add, not in finish: what is left then are the primitives that were kept. If these are drawn " +
            "again, their fragments still count once.",
    )
    public fun rule_7_10_primitivesOneByOneAreCounted() {
        val renderer = requireStreaming(renderer())
        for (step in listOf(1, -1)) {
            val drawing = renderer.begin(Raster(4, 4))
            repeat(MANY) { drawing.add(Stripe(0..3, 0..3, 2 * MANY + step * it)) }
            val visible = if (step > 0) 0 else MANY - 1
            val counted = drawing.finish { y, _, _, primitive ->
                if (primitive[0] != visible) fail(renderer, "row $y shows primitive ${primitive[0]}, not $visible")
            }.primitives
            if (counted != MANY.toLong()) fail(renderer, "$MANY primitives were added, but $counted are counted")
        }

        // One sample each, so all of them are visible
        val raster = Raster(MANY_COLUMNS, MANY / MANY_COLUMNS)
        val drawing = renderer.begin(raster)
        repeat(MANY) {
            val (column, row) = it % MANY_COLUMNS to it / MANY_COLUMNS
            drawing.add(Stripe(column..column, row..row, it))
        }
        val counters = drawing.finish { _, _, _, _ -> }
        if (counters.fragments != MANY.toLong() || counters.depthPasses != MANY.toLong()) {
            fail(renderer, "$MANY primitives with one sample each were added, but the counters are $counters")
        }
    }

    /** A frame of streamed meshes gives the same picture as one in memory, or is refused. */
    @Rule(
        intent = "A renderer that accepts a streamed frame gives the picture that the same triangles in memory have.",
        look =
        "Look at ties between parts, whose order is that of the scene, and at the indices of later parts. Throw " +
            "IllegalArgumentException before the first row if primitives are needed more than once.",
        tries = 60,
    )
    public fun rule_7_5_streamedFramesGiveTheSamePicture(@ForAll salt: Long) {
        val renderer = renderer()
        for (options in listOf(RenderOptions(threads = 1), optionsForStreams(salt))) {
            streamedIsTheSame(renderer.configured(options.supportedBy(renderer)), salt)
        }
    }

    /** A picture that is complete, or whose primitive failed, takes no more primitives and delivers no more rows. */
    @Rule(
        intent = "A picture cannot be continued after it was delivered, or after a primitive failed half-way.",
        look = "Throw IllegalStateException from both functions of the Rendering once finish was called or add has " +
            "thrown.",
        tries = 30,
    )
    public fun rule_7_10_endedPicturesCannotBeContinued(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = requireStreaming(renderer())
        val opaque = case.frame.asOpaque()
        val finished = renderer.begin(opaque.raster, opaque.region)
        opaque.primitives.forEach(finished::add)
        finished.finish { _, _, _, _ -> }
        hasEnded(renderer, finished, "by finish")

        // The sink refuses a row
        val random = Random(salt)
        val last = opaque.region.rowStart + random.nextInt(opaque.height)
        val refused = renderer.begin(opaque.raster, opaque.region)
        opaque.primitives.forEach(refused::add)
        answer { refused.finish { y, _, _, _ -> check(y < last) { "enough" } } }
        hasEnded(renderer, refused, "by finish, although the sink threw an exception")

        // A primitive fails in one of its first queries
        val question = Question.entries[random.nextInt(Question.entries.size)]
        val planted = Planted.entries[random.nextInt(Planted.entries.size)].make()
        val trap = Trap(opaque, question, random.nextInt(MOST_CALLS), planted)
        val failed = renderer.begin(opaque.raster, opaque.region)
        val thrown = answer { trap.frame.primitives.forEach(failed::add) }
        if (thrown != null) hasEnded(renderer, failed, "because a primitive threw an exception")
    }

    private companion object {
        /** More than renderers collect before they draw. */
        const val MANY = 40_000
        const val MANY_COLUMNS = 250

        /** Exclusive limit of the number of calls that a primitive answers before it throws. */
        const val MOST_CALLS = 6
    }
}
