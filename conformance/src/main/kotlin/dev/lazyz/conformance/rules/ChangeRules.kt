package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.backed
import dev.lazyz.conformance.cases.changed.cutAtColumn
import dev.lazyz.conformance.cases.changed.cutAtRow
import dev.lazyz.conformance.cases.changed.doubled
import dev.lazyz.conformance.cases.changed.inOrder
import dev.lazyz.conformance.cases.changed.keeping
import dev.lazyz.conformance.cases.changed.moved
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.ScreenCases
import dev.lazyz.conformance.frames.screen.moved
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.isTie
import dev.lazyz.conformance.probes.closeToAWall
import java.util.Random
import net.jqwik.api.ForAll

/** Rules about frames that are changed in a way whose effect on the picture is known. Part of `RendererConformance`. */
public sealed interface ChangeRules : RulesForOne {
    /** Moving all primitives by whole pixels moves the picture and changes nothing else. */
    @Rule(
        intent = "A move by whole pixels moves the picture and changes nothing else.",
        look = "Look for results that depend on absolute x or y: blocks, tiles, and linear forms in floating point.",
    )
    public fun rule_1_3_movingByWholePixelsMovesThePicture(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val random = Random(salt)
        val right = random.nextInt(MOST_PIXELS)
        val down = random.nextInt(MOST_PIXELS)
        val before = Judgement(renderer, case).rendering.image
        val after = Judgement(renderer, case.moved(right, down))
        val expected = before.moved(right, down, case.frame.raster)
        difference(expected, after.rendering.image)?.let { after.fail("moved: $it") }
    }

    /** Cutting each primitive in two along a column or a row does not change colours or depths. */
    @Rule(
        intent = "Two parts of a primitive cover what the whole covers: no gap, no sample drawn twice, the same depth.",
        look = "Look at the first and last column of a span, and at state that is carried from one span to the next.",
        about = [Symptom.COVERAGE],
    )
    public fun rule_2_5_primitivesCutInTwoGiveTheSamePicture(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val random = Random(salt)
        val whole = Judgement(renderer, case).rendering.image
        val column = case.cutAtColumn(random.nextInt(case.frame.width))
        val row = case.cutAtRow(random.nextInt(case.frame.height))
        for (halves in listOf(column, row)) {
            val judgement = Judgement(renderer, halves)
            val actual = judgement.rendering.image.renumbered { it / 2 }
            difference(whole, actual)?.let { judgement.fail("with each primitive cut in two: $it") }
        }
    }

    /** Adding a surface behind everything visible changes nothing. */
    @Rule(
        intent = "Hidden surfaces have no effect on the picture.",
        look = "Look at rejection by bounds: the hidden surface has loose bounds and lies one unit behind the picture.",
    )
    public fun rule_5_1_hiddenSurfacesChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val before = Judgement(renderer, case).rendering
        val backed = Judgement(renderer, case.backed(before.image))
        difference(before.image, backed.rendering.image)?.let { backed.fail("with a hidden surface: $it") }
        if (Capability.SHADES_ONLY_VISIBLE !in renderer.capabilities) return
        val more = backed.rendering.counters.shadingCalls - before.counters.shadingCalls
        if (more != 0L) backed.fail("a hidden surface is shaded, $more times")
    }

    /** Merging the pictures of two halves of the primitives gives the picture of all primitives. */
    @Rule(
        intent = "Threads, tiles and machines can render parts of a frame and merge the results in any order.",
        look =
        "Primitives that Frame.keeping leaves out must keep their indices, and what is left of one picture must " +
            "not be part of the next.",
    )
    public fun rule_5_1_mergedPartsEqualTheWholePicture(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val even = Judgement(renderer, case.keeping(0)).equalsReference().rendering.image
        val odd = Judgement(renderer, case.keeping(1)).equalsReference().rendering.image
        val whole = Judgement(renderer, case)
        difference(Image.merge(even, odd, case.frame.raster), whole.rendering.image)?.let { whole.fail("merged: $it") }
    }

    /** Submitting all primitives a second time changes nothing, except the indices where a tie goes to the last. */
    @Rule(
        intent = "A primitive that is submitted twice looks as if it were submitted once.",
        look = "Look at ties between a primitive and its copy, and at tables keyed by the primitive instead of its " +
            "index.",
    )
    public fun rule_5_2_duplicatesChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val test = case.frame.raster.depthTest
        val once = Judgement(renderer, case).rendering.image
        val doubled = Judgement(renderer, case.doubled())
        val isLastFirst = test == DepthTest.LESS_OR_EQUAL || test == DepthTest.GREATER_OR_EQUAL
        val expected = if (isLastFirst) once.renumbered { it + case.frame.primitives.size } else once
        difference(expected, doubled.rendering.image)?.let { doubled.fail("with all primitives twice: $it") }
    }

    /** Another order of submission shows the same picture, except where two primitives have the same winning depth. */
    @Rule(
        intent = "Without ties, the order of submission changes only the indices.",
        look = "Look for results that depend on the order of arrival: early rejection, sorting without a total " +
            "order, state.",
        about = [Symptom.ORDER],
    )
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
            reordered.fail("sample ($x, $y) shows primitive $a, but $b with the order of submission $order")
        }
    }

    /** A region is rendered exactly as that part of the whole picture, and nothing outside it is rendered. */
    @Rule(
        intent = "The picture of a region equals that rectangle of the whole picture.",
        look = "Primitives use columns and rows of the raster; only the arrays of a row begin at the region's left " +
            "edge.",
        about = [Symptom.REGION],
    )
    public fun rule_7_4_regionEqualsThatPartOfThePicture(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val part = case.withinAny(Random(salt))
        Judgement(renderer(), part).equalsReference().equalsItsImage().rowsInOrder()
        Judgement(renderer().configured(RenderOptions(tileSize = 8)), part, "tiles of 8 x 8 samples").equalsReference()
    }

    /** Parts of a frame of many hidden triangles are that part of the picture, wherever they begin. */
    @Rule(
        intent = "A region may begin at any row and column, also within what a renderer takes for a block or a tile.",
        look = "Look for blocks of rows that are counted from the raster in one place, and from the region in another.",
        about = [Symptom.REGION], tries = 20,
    )
    public fun rule_7_4_regionsOfManyLayersAreDrawnCorrectly(@ForAll salt: Long) {
        Judgement(renderer(), closeToAWall(salt).withinAny(Random(salt))).equalsReference()
    }

    /** Options change the cost of a rendering, never its picture, and never the renderer that is asked for them. */
    @Rule(
        intent = "Coherence, memory budget, threads and tile size change the cost, never the picture, and " +
            "`configured` leaves its renderer as it is.",
        look = "The message names the options: compare stepped colours with direct ones, check the edges of tiles, " +
            "and let `configured` return another renderer.",
        about = [Symptom.OPTIONS], tries = 50,
    )
    public fun rule_7_5_optionsChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        for (coherence in Coherence.entries) {
            for (budget in listOf(null, 0L, 1000L)) {
                val threads = if (budget == null) 3 else 1
                val renderer = renderer()
                val options = RenderOptions(coherence, budget, threads, tileSize = 8).supportedBy(renderer)
                Judgement(renderer.configured(options), case, "$options").equalsReference()
            }
        }
        if (case.frame.primitives.isNotEmpty()) leavesItself(renderer(), case)
    }

    /** Fails if [renderer] is another one after it has been asked for a renderer with other options. */
    private fun leavesItself(renderer: Renderer, case: FrameCase) {
        fun shaded() = Recording.of(renderer, case.frame).let { it.image to it.counters.shadingSteps }
        val (image, steps) = shaded()
        val none = Selector { _ -> }
        for (coherence in Coherence.entries) {
            renderer.configured(RenderOptions(coherence, memoryBudget = 0L, selector = none).supportedBy(renderer))
            val (after, stepsAfter) = shaded()
            if (difference(image, after) == null && steps == stepsAfter) continue
            val what = "configured() changes the renderer itself: it must return another one"
            throw Violation("${renderer.id}: $what\nin\n$case", case, image, after, isConfigured = true, isPlain = true)
        }
    }

    private companion object {
        /** Exclusive limit of the moves, in columns and rows. Large enough to cross the edges of small tiles. */
        const val MOST_PIXELS = 12
    }
}
