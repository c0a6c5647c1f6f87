package dev.lazyz.conformance.frames

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.moved
import dev.lazyz.conformance.cases.changed.within
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.listsOf
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.conformance.frames.screen.moved
import dev.lazyz.conformance.frames.screen.screenCase
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

// Frames that are larger than the others in one respect, but still take only milliseconds to render.

/** Frames on rasters of several tiles and bands, for tile sizes of 8 to 256. Most sides are odd. */
internal class SeveralTilesCases :
    Cases({
        val sides = oneOf(65, 67, 127, 129, 131, 128, 257, 263, 293, 521)
        val areas = Combinators.combine(sides, sides).`as` { width, height ->
            LargeArea(width, if (width * height > MOST_SAMPLES) height % 64 + 1 else height)
        }
        largeCases(areas)
    })

private const val MOST_SAMPLES = 80_000

/** Frames whose column or row numbers, or both, do not fit into 16 bits. */
internal class FarAwayCases :
    Cases({
        val across = LargeArea(Raster.MAX_SIDE, Raster.MAX_SIDE, Region(65_500, 65_499, 65_590, 65_570))
        val lastCorner = LargeArea(
            Raster.MAX_SIDE,
            Raster.MAX_SIDE,
            Region(Raster.MAX_SIDE - 67, Raster.MAX_SIDE - 89, Raster.MAX_SIDE, Raster.MAX_SIDE),
        )
        val farRight = LargeArea(Raster.MAX_SIDE, 64, Region(131_050, 0, 131_133, 61))
        val farDown = LargeArea(64, Raster.MAX_SIDE, Region(3, 32_750, 64, 32_790))
        largeCases(oneOf(across, LargeArea(70_001, 1), LargeArea(2, 70_001), lastCorner, farRight, farDown))
    })

/** A raster and the region of it to render. */
internal class LargeArea(val width: Int, val height: Int, val region: Region = Region(0, 0, width, height))

private const val GROUP_WIDTH = 293
private const val GROUP_HEIGHT = 277

private fun largeCases(areas: Arbitrary<LargeArea>): Arbitrary<FrameCase> {
    val pieces = ScreenKinds(GROUP_WIDTH, GROUP_HEIGHT)
    val kinds = listOf(
        FrameKind.SCATTERED, FrameKind.COMBS, FrameKind.INTERPENETRATING, FrameKind.HOLES, FrameKind.SHARED_EDGES,
        FrameKind.SLIVERS, FrameKind.CONFETTI, FrameKind.SELF_CROSSING,
    )
    val groups = mixed(*kinds.map { 1 to pieces.of(it) }.toTypedArray())
    val backs = Combinators.combine(ScreenKinds.depths, ScreenKinds.depths, ints(0, 9)).`as` { left, right, place ->
        Triple(left, right, place)
    }
    return Combinators.combine(areas, Frames.rasters(1, 1), listsOf(groups, MOST_GROUPS), backs, Arbitraries.longs())
        .`as` { area, small, list, back, salt ->
            val raster = with(small) {
                Raster(area.width, area.height, background, convention, depthTest, backgroundDepth)
            }
            val random = Random(salt)
            val placed = list.map { it.moved(area.region.placed(random, 0), area.region.placed(random, 1)) }
            val all = placed.flatten().take(MOST_PIECES).toMutableList()
            val (left, right, place) = back
            val plate = with(area.region) {
                Plate(columnStart - 1.0, rowStart - 1.0, columnEnd + 1.0, rowEnd + 1.0, left, right)
            }
            all.add(minOf(place, all.size), plate.piece())
            val case = screenCase(raster, all)
            if (area.region == raster.region) case else case.within(area.region)
        }.withoutEdgeCases()
}

private const val MOST_GROUPS = 6
private const val MOST_PIECES = 9

/** Returns the position of a group along a side: at its start, at its end, or anywhere. */
private fun Region.placed(random: Random, axis: Int): Int {
    val start = if (axis == 0) columnStart else rowStart
    val room = maxOf(if (axis == 0) width - GROUP_WIDTH else height - GROUP_HEIGHT, 0)
    return start + when (random.nextInt(4)) {
        0 -> 0
        1 -> room
        else -> random.nextInt(room + 1)
    }
}

/** Frames with up to eighty spans in a row. */
internal class ManySpansCases :
    Cases({
        Frames.of(FrameMix.of(FrameKind.COMBS, FrameKind.CONFETTI).with(FrameKind.COMBS, 3).sized(300, 9).counted(1, 6))
    })

/** Frames with dozens of primitives at most samples. */
internal class DozensOfLayersCases :
    Cases({
        val kinds = FrameMix.of(
            FrameKind.LAYERED, FrameKind.NEARLY_COPLANAR, FrameKind.COPLANAR, FrameKind.CONFETTI,
            FrameKind.INTERPENETRATING,
        )
        Frames.of(kinds.sized(12, 9).counted(30, 90).layered(40))
    })

/** Frames of up to nine thousand primitives, mostly more than 12 bits can number. */
internal class ThousandsOfLayersCases : Cases({ manyLayers(mixed(1 to ints(1, 3000), 2 to ints(4200, 9000))) })

/** Frames of about a thousand primitives. */
internal class ThousandLayersCases : Cases({ manyLayers(ints(600, 1200)) })

/** Returns frames of [counts] primitives, each of which covers most of the few samples. */
private fun manyLayers(counts: Arbitrary<Int>): Arbitrary<FrameCase> =
    Combinators.combine(counts, ints(0, 1000), oneOf(1, 5, 1000)).`as` { count, seed, levels ->
        FrameCase(
            Frame(Raster(3, 2), List(count) { Confetti(seed + it, 0, 3, 0, 2, levels) }),
            "Frame(Raster(3, 2), List($count) { Confetti($seed + it, 0, 3, 0, 2, $levels) })",
        )
    }.withoutEdgeCases()
