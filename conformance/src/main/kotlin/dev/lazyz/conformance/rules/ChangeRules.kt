package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.RenderOptions
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
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.isTie
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about frames that are changed in a way whose effect on the picture is known. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface ChangeRules : RulesForOne {
    /** A frame whose primitives all move by whole pixels shows the same picture in another place. */
    @Rule(
        intent = "A move by whole pixels changes the place and nothing else.",
        look = "Look for results that depend on x or y themselves: blocks, tiles, and forms in floating point.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
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

    /** Each primitive cut in two along a column or a row leaves colours and depths as they are. */
    @Rule(
        intent = "Coverage in parts is coverage: no crack, no sample drawn twice, the same depth on both sides.",
        look = "Look at the first and the last column of a span, and at state that is carried from a span to the next.",
        about = [Symptom.COVERAGE],
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_2_5_primitivesInTwoPartsAreTheWhole(
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
            difference(whole, actual)?.let { judgement.fail("in halves, numbered as before: $it") }
        }
    }

    /** One more surface behind all that is visible changes nothing. */
    @Rule(
        intent = "What is hidden has no influence: the minimum does not see what is greater.",
        look = "Look at rejection by bounds: a surface with loose bounds one unit behind the picture loses everywhere.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_hiddenSurfacesChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val before = Judgement(renderer, case).rendering
        val backed = Judgement(renderer, case.backed(before.image))
        difference(before.image, backed.rendering.image)?.let { backed.fail("with a hidden surface: $it") }
        if (Capability.SHADES_ONLY_VISIBLE !in renderer.capabilities) return
        val more = backed.rendering.counters.shadingCalls - before.counters.shadingCalls
        if (more != 0L) backed.fail("a hidden surface is shaded, $more times")
    }

    /** The pictures of two halves of the primitives, merged, are the picture of all. */
    @Rule(
        intent = "Any number of threads, tiles and machines may merge their results in any order.",
        look = "Primitives that Frame.keeping left out must keep their places in the numbering.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_partsMergeIntoTheWhole(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val even = Judgement(renderer, case.keeping(0)).equalsReference().rendering.image
        val odd = Judgement(renderer, case.keeping(1)).equalsReference().rendering.image
        val whole = Judgement(renderer, case)
        difference(Image.merge(even, odd, case.frame.raster), whole.rendering.image)?.let { whole.fail("merged: $it") }
    }

    /** All primitives submitted a second time change nothing, but for the numbers where a tie goes to the last. */
    @Rule(
        intent = "The minimum is idempotent: what is submitted twice is seen once.",
        look = "Look at ties between a primitive and its copy, and at tables keyed by the primitive, not its index.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_2_duplicatesChangeNothing(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val test = case.frame.raster.depthTest
        val once = Judgement(renderer, case).rendering.image
        val doubled = Judgement(renderer, case.doubled())
        val isLastFirst = test == DepthTest.LESS_OR_EQUAL || test == DepthTest.GREATER_OR_EQUAL
        val expected = if (isLastFirst) once.renumbered { it + case.frame.primitives.size } else once
        difference(expected, doubled.rendering.image)?.let { doubled.fail("with all primitives twice: $it") }
    }

    /** In another order the same is visible, except where two primitives have the same, winning depth. */
    @Rule(
        intent = "Without ties, the order of submission changes nothing but the indices.",
        look = "Look for results that depend on who came first: early rejection, sorting that is not total, state.",
        about = [Symptom.ORDER],
    )
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

    /** Part of a raster is rendered as that part of the whole picture, and nothing else is. */
    @Rule(
        intent = "The picture of a region is that rectangle of the whole picture.",
        look = "Columns and rows of primitives are the raster's; only the row's arrays begin at the region.",
        about = [Symptom.REGION],
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_4_regionIsThatPartOfThePicture(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        Judgement(renderer(), case.withinAny(Random(salt))).equalsReference().equalsItsImage().rowsInOrder()
    }

    /** Options change what a rendering costs, and never its picture. */
    @Rule(
        intent = "Coherence, memory budget, threads and tile size are about cost, never about the picture.",
        look = "The message names the options: compare stepped colours, or the tiles' edges, with direct ones.",
        about = [Symptom.OPTIONS],
    )
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

    private companion object {
        /** Pictures move by fewer columns and rows: across the edges of small tiles. */
        const val MOST_PIXELS = 12
    }
}
