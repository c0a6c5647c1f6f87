package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.cases.ALL_GLASS
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Multitude
import dev.lazyz.conformance.cases.changed.MILLIONS
import dev.lazyz.conformance.cases.changed.behindMillions
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.cases.thin
import dev.lazyz.conformance.frames.DozensOfLayersCases
import dev.lazyz.conformance.frames.FarAwayCases
import dev.lazyz.conformance.frames.ManySpansCases
import dev.lazyz.conformance.frames.SeveralTilesCases
import dev.lazyz.conformance.frames.ThousandLayersCases
import dev.lazyz.conformance.frames.ThousandsOfLayersCases
import dev.lazyz.conformance.frames.TwoRowsCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.Selection
import dev.lazyz.conformance.probes.closeToAWall
import dev.lazyz.conformance.probes.crowdedTile
import dev.lazyz.conformance.probes.edgesAtTheEndsOfTiles
import dev.lazyz.conformance.probes.immense
import dev.lazyz.conformance.probes.longRasters
import dev.lazyz.conformance.probes.seenThroughGaps
import dev.lazyz.conformance.probes.slivers
import dev.lazyz.conformance.probes.specks
import dev.lazyz.conformance.probes.spiral
import dev.lazyz.conformance.probes.wideMesh
import dev.lazyz.conformance.probes.withinAUnit
import net.jqwik.api.ForAll

/** Rules about frames that are large in one respect: sides, spans, layers or indices. Part of `RendererConformance`. */
public sealed interface SizeRules : RulesForOne {
    /** Rasters of several tiles and bands, of any size; most have odd sides. Some tiles have small triangles only. */
    @Rule(
        intent = "A picture of many tiles is correct in each tile, including the partial tiles at the right and the " +
            "bottom.",
        look = "Look at the last column and row of a tile or band, at the last tile, at primitives that cross tiles, " +
            "and at tiles that are skipped.",
        tries = 25,
    )
    public fun rule_1_1_rastersOfSeveralTilesAreDrawnCorrectly(
        @ForAll(supplier = SeveralTilesCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        Judgement(renderer(), case).equalsReference().rowsInOrder()
        Judgement(renderer(), specks(salt)).equalsReference()
    }

    /** Columns and rows beyond 65,536, on long rasters and in regions of large ones. */
    @Rule(
        intent = "A side has up to 262,144 samples: columns and rows need 18 bits, and the size of a raster needs 36.",
        look = "Look for columns and rows in 16 bits, and for row times width in 32; allocate only for the region.",
        isSpecial = true, tries = 12,
    )
    public fun rule_1_1_columnsAndRowsAreNotTruncated(@ForAll(supplier = FarAwayCases::class) case: FrameCase) {
        val renderer = renderer()
        Judgement(renderer, case).equalsReference().rowsInOrder()

        // Renderers that blend may have other code for translucent primitives
        if (Capability.TRANSPARENCY in renderer.capabilities) {
            Judgement(renderer, case.glazed(ALL_GLASS)).equalsReference()
        }
        if (Capability.SELECTION in renderer.capabilities) {
            val byPlace = Selection.byPlace
            Judgement(renderer.configured(RenderOptions(selector = byPlace.selector)), case, "a selector by place")
                .equalsPicture(byPlace.of(case.frame))
        }
    }

    /** A few primitives on rasters of thousands of small tiles, side by side or one below the other. */
    @Rule(
        intent = "There can be thousands of tiles in a row or a column, and primitives are submitted in any order.",
        look = "Look for numbers of tiles in too few bits, and for a sort by row whose later passes are missing.",
        isSpecial = true, tries = 1,
    )
    public fun rule_1_1_thousandsOfTilesAreDrawnCorrectly(@ForAll salt: Long) {
        for (case in longRasters(salt)) {
            val expected = Judgement(renderer(), case).equalsReference().rendering.image
            val options = RenderOptions(tileSize = 8)
            Judgement(renderer().configured(options), case, "$options").equalsPicture(expected)
        }
    }

    /** A mesh of small and larger triangles gives the same picture with tiles of every size, and a tile may be full. */
    @Rule(
        intent = "The size of tiles changes no bit, however many samples and triangles a tile has.",
        look = "Look for places and numbers within a tile in too few bits, and for tiles at the right and lower edge.",
        tries = 1,
    )
    public fun rule_7_5_tilesOfEverySizeGiveTheSamePicture(@ForAll salt: Long) {
        val case = wideMesh(salt)
        val expected = Judgement(renderer(), case).equalsReference().rendering.image
        for (shift in 3..9) {
            val options = RenderOptions(tileSize = 1 shl shift)
            Judgement(renderer().configured(options), case, "$options").equalsPicture(expected)
        }
        Judgement(renderer(), crowdedTile(salt)).equalsReference()
    }

    /** Wide triangles with edges through the samples at the ends of tiles, and with a gap between them. */
    @Rule(
        intent = "A triangle hides what is behind it only at samples that it covers: the top-left rule also holds at " +
            "the ends of tiles.",
        look = "Look at the test that a triangle covers a tile: a sample on an edge that does not own it is not " +
            "covered. What is hidden in the tiles at its ends may be visible between them.",
        tries = 1,
    )
    public fun rule_2_2_wideTrianglesHideOnlyWhatTheyCover(@ForAll salt: Long) {
        for (case in edgesAtTheEndsOfTiles(salt) + seenThroughGaps(salt)) Judgement(renderer(), case).equalsReference()
    }

    /** Dozens of spans in one row of a primitive. */
    @Rule(
        intent = "A primitive can have any number of spans in a row.",
        look = "Look for arrays with a fixed number of spans or edges, and for what happens when they are full.",
        tries = 40,
    )
    public fun rule_2_3_allSpansOfARowAreDrawn(@ForAll(supplier = ManySpansCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Thousands of spans in one row of a primitive. */
    @Rule(
        intent = "A primitive can have as many spans in a row as there are columns, and a row as many edges.",
        look = "Look for numbers of spans, edges or intervals that are packed into fewer than 18 bits.",
        isSpecial = true,
    )
    public fun rule_2_3_thousandsOfSpansAreDrawn() {
        val multitude = Multitude.ofSpans()
        Judgement(renderer(), multitude.case).equalsPicture(multitude.image)
    }

    /**
     * Many triangles hardly in front of a wall, and hardly behind it; within a unit of depth of each other; of any
     * size, with equal depths; around a point, in a spiral; and seen edge-on.
     */
    @Rule(
        intent = "A fragment that is nearer by a single unit of depth is visible, however many others are near it.",
        look = "Look for triangles that are rejected because another one was: a rough order of depths is no order, " +
            "and rounding changes that of near planes. Slivers seen edge-on have one depth.",
        about = [Symptom.ORDER], tries = 3,
    )
    public fun rule_5_1_trianglesCloseToAWallAreDrawnCorrectly(@ForAll salt: Long) {
        val renderer = renderer()
        Judgement(renderer, closeToAWall(salt)).equalsReference()
        for (case in immense(salt) + spiral(salt)) Judgement(renderer, case).equalsReference()
        repeat(MANY_SHEETS) { Judgement(renderer, withinAUnit(salt + it)).equalsReference() }
        Judgement(renderer, slivers(salt, Capability.TRANSPARENCY in renderer.capabilities)).equalsReference()
    }

    /** Dozens of primitives at one sample. Also blended, by renderers that blend. */
    @Rule(
        intent = "The visible fragment is the minimum of any number of fragments, in any order.",
        look = "Look for lists of fragments, bins or active primitives of a fixed length.",
        tries = 12,
    )
    public fun rule_5_1_nearestOfDozensOfLayersIsVisible(
        @ForAll(supplier = DozensOfLayersCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Thousands of primitives at each of a few samples. */
    @Rule(
        intent = "The minimum is also correct for thousands of fragments, without deep recursion.",
        look = "Look for recursion from primitive to primitive, and for counts of fragments in a byte or a short.",
        isSpecial = true, tries = 6,
    )
    public fun rule_5_1_nearestOfThousandsOfLayersIsVisible(
        @ForAll(supplier = ThousandsOfLayersCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /**
     * More than a million fragments in one row, more than a renderer may want to hold at once; and tens of thousands at
     * one sample, in the order of their depths and in the reverse order.
     */
    @Rule(
        intent = "A row and a sample have any number of fragments, in any order.",
        look = "Look for what a piece of a row knows of the spans that began in the piece before, and for recursion " +
            "whose depth is the number of fragments, as in a sort.",
        isSpecial = true,
    )
    public fun rule_5_1_nearestOfAMillionFragmentsOfARowIsVisible() {
        for (it in listOf(Multitude.ofRow()) + sorted(isTranslucent = false)) {
            Judgement(renderer(), it.case).equalsPicture(it.image)
        }
    }

    private fun sorted(isTranslucent: Boolean): List<Multitude> =
        listOf(false, true).map { Multitude.ofSorted(it, isTranslucent) }

    /** Dozens of layers, each nearly transparent; some of them may be opaque. */
    @Rule(
        intent = "Blending includes every fragment that shows through, however many there are.",
        look = "Look for a limit on the number of layers, and for fragments that are merged or dropped to save memory.",
        isSpecial = true, tries = 12,
    )
    public fun rule_5_5_dozensOfThinLayersBlend(
        @ForAll(supplier = DozensOfLayersCases::class) case: FrameCase,
        @ForAll salt: Int,
    ) {
        val renderer = renderer(Capability.TRANSPARENCY)
        val layers = case.frame.primitives.size
        Judgement(renderer, case.thin(layers)).equalsReference()

        // An opaque primitive hides layers that came before it, however many stay visible
        val opaque = setOf(Math.floorMod(salt, layers), layers - 1)
        Judgement(renderer, case.thin(layers, opaque)).equalsReference()
    }

    /**
     * Many layers at many samples: more fragments at once than fit into small buffers; and tens of thousands at one
     * sample, in the order of their depths and in the reverse order.
     */
    @Rule(
        intent = "Blending includes all fragments of a tile, a band or a picture, however many there are.",
        look = "Look for a store of fragments that is full, for positions in it in 16 bits, and for recursion whose " +
            "depth is the number of fragments, as in a sort.",
        isSpecial = true,
    )
    public fun rule_5_5_millionFragmentsBlend() {
        val renderer = renderer(Capability.TRANSPARENCY)
        for (it in listOf(Multitude.ofFragments()) + sorted(isTranslucent = true)) {
            Judgement(renderer, it.case).equalsPicture(it.image)
        }
    }

    /** A thousand layers, each nearly transparent, at each of a few samples. */
    @Rule(
        intent = "Blending includes a thousand fragments as it includes two.",
        look = "Look for a limit on the number of layers, and for counts of them in a byte.",
        isSpecial = true, tries = 2,
    )
    public fun rule_5_5_thousandThinLayersBlend(@ForAll(supplier = ThousandLayersCases::class) case: FrameCase) {
        val renderer = renderer(Capability.TRANSPARENCY)
        Judgement(renderer, case.thin(case.frame.primitives.size)).equalsReference()
    }

    /** Indices that a float cannot represent, behind more than 2^24 primitives that cover nothing. */
    @Rule(
        intent = "Indices have 31 bits: those above 2^24 are neither rounded to a float nor cut to 24 bits.",
        look = "Look at keys that pack fewer than 31 bits of index, and at indices in floating point.",
        isSpecial = true, tries = 1,
    )
    public fun rule_9_4_indicesAboveTwoToThe24AreExact(@ForAll(supplier = TwoRowsCases::class) case: FrameCase) {
        val renderer = renderer()
        val few = Judgement(renderer, case).equalsReference().rendering.image
        val behind = Judgement(renderer, case.behindMillions())
        val first = case.frame.primitives.size / 2
        val expected = few.renumbered { if (it < first) it else it + MILLIONS }
        difference(expected, behind.rendering.image)?.let { behind.fail("behind millions: ", it) }
    }
}

private const val MANY_SHEETS = 20
