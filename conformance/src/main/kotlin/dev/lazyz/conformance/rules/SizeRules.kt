package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.MILLIONS
import dev.lazyz.conformance.cases.changed.behindMillions
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.cases.thin
import dev.lazyz.conformance.frames.DozensOfLayersCases
import dev.lazyz.conformance.frames.FarAwayCases
import dev.lazyz.conformance.frames.ManySpansCases
import dev.lazyz.conformance.frames.SeveralTilesCases
import dev.lazyz.conformance.frames.ThousandsOfLayersCases
import dev.lazyz.conformance.frames.TwoRowsCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.requireDeclared
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about frames that are large in one respect: sides, spans, layers, indices. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface SizeRules : RulesForOne {
    /** Rasters of several tiles and bands, whatever their size, most with odd sides. */
    @Rule(
        intent = "A picture of many tiles is right in each of them, and in what is left over at the right and below.",
        look = "Look at the last column and row of a tile or band, at the last tile, and at what crosses tiles.",
    )
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_1_1_rastersOfSeveralTilesAreOrdinary(
        @ForAll(supplier = SeveralTilesCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference().rowsInOrder()
    }

    /** Columns and rows beyond 65,536, on long rasters and in parts of large ones. */
    @Rule(
        intent = "A side has up to 262,144 samples: columns and rows need 18 bits, and a raster's size needs 36.",
        look = "Look for columns and rows in 16 bits, and for row times width in 32; keep what the region needs.",
    )
    @Property(tries = 12, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_1_1_columnsAndRowsAreNotCut(@ForAll(supplier = FarAwayCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference().rowsInOrder()
    }

    /** Dozens of spans in a row of one primitive. */
    @Rule(
        intent = "A primitive covers any number of spans in a row.",
        look = "Look for arrays of a fixed number of spans or edges, and for what happens when they are full.",
    )
    @Property(tries = 40, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_2_3_manySpansInARowAreOrdinary(@ForAll(supplier = ManySpansCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Dozens of primitives at a sample; blended, too, by renderers that blend. */
    @Rule(
        intent = "The minimum is the minimum of any number of fragments, in whatever order they come.",
        look = "Look for lists of fragments, bins or active primitives of a fixed length.",
    )
    @Property(tries = 12, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_dozensOfLayersAreOrdinary(@ForAll(supplier = DozensOfLayersCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Thousands of primitives at each of a few samples. */
    @Rule(
        intent = "The minimum is the minimum of thousands of fragments, too, and finding it takes no stack.",
        look = "Look for recursion from primitive to primitive, and for counts of fragments in a byte or a short.",
    )
    @Property(tries = 6, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_1_thousandsOfLayersAreOrdinary(
        @ForAll(supplier = ThousandsOfLayersCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Dozens of layers that each let through nearly all of what is behind. */
    @Rule(
        intent = "Blending takes every fragment that shows through, however many there are.",
        look = "Look for a greatest number of layers, and for fragments that are merged or dropped to save memory.",
    )
    @Property(tries = 12, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_5_dozensOfThinLayersBlend(@ForAll(supplier = DozensOfLayersCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.TRANSPARENCY)
        Judgement(renderer, case.thin(case.frame.primitives.size)).equalsReference()
    }

    /** Indices that a float cannot hold, behind more than 2^24 primitives that cover nothing. */
    @Rule(
        intent = "Indices have 31 bits: those above 2^24 are neither rounded by a float nor cut to 24 bits.",
        look = "Look at keys that are packed with less than 31 bits of index, and at indices in floating point.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_9_4_indicesAboveTwoToThe24AreExact(@ForAll(supplier = TwoRowsCases::class) case: FrameCase) {
        val renderer = renderer()
        val few = Judgement(renderer, case).equalsReference().rendering.image
        val behind = Judgement(renderer, case.behindMillions())
        val first = case.frame.primitives.size / 2
        val expected = few.renumbered { if (it < first) it else it + MILLIONS }
        difference(expected, behind.rendering.image)?.let { behind.fail("behind millions: ", it) }
    }
}
