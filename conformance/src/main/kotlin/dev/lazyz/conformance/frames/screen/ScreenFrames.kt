package dev.lazyz.conformance.frames.screen

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.listsOf
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.spi.LinearForm
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/** Generates frames of [Piece]s around a raster of at most [maxWidth] x [maxHeight] samples. */
internal class ScreenFrames(private val maxWidth: Int, private val maxHeight: Int) {
    private val polygons = ScreenPolygons(maxWidth, maxHeight)

    fun cases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> {
        val confetti = confetti().map { listOf(it) }
        val all = mixed(6 to polygons.single(), 1 to polygons.twins(), 2 to polygons.fan(), 1 to confetti)
        return frames(rasters, all, max)
    }

    fun tiedCases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> {
        val level = polygons.level().map { listOf(it) }
        val confetti = confetti().map { listOf(it) }
        return frames(rasters, mixed(3 to polygons.twins(), 3 to level, 1 to confetti), max)
    }

    fun confettiCases(rasters: Arbitrary<Raster>, max: Int): Arbitrary<FrameCase> =
        frames(rasters, confetti().map { listOf(it) }, max)

    fun frames(rasters: Arbitrary<Raster>, groups: Arbitrary<List<Piece>>, max: Int): Arbitrary<FrameCase> =
        Combinators.combine(rasters, listsOf(groups, max), oneOf(*PieceOrder.values())).`as` { raster, list, order ->
            screenCase(raster, order.of(list.map { it.broughtTo(raster) }).take(max))
        }

    fun confetti(): Arbitrary<Piece> {
        val columns = range(maxWidth)
        val ordered = range(maxHeight)

        // An empty range of rows may also have an end before its start
        val rows = mixed(29 to ordered, 1 to ordered.map { it.last..it.first })
        val levels = oneOf(1, 2, 5, 1000)
        val hashed = Combinators.combine(Arbitraries.integers(), columns, rows, levels)
            .`as` { seed, column, row, level -> ConfettiPiece(seed, column, row, level, null) }
        val longs = Arbitraries.longs()
        val starts = mixed(3 to longs.map { if (it < 0) it.inv() else it }, 1 to longs)
        val formed = Combinators.combine(Arbitraries.integers(), columns, ordered, starts, longs, longs)
            .`as` { seed, column, row, c, dx, dy -> ConfettiPiece(seed, column, row, 1, LinearForm(c, dx, dy)) }

        // At the depth of confetti with a single level, or one unit in front of or behind it, with tight bounds
        val level = Combinators.combine(Arbitraries.integers(), columns, ordered, ints(-1, 1))
            .`as` { seed, column, row, lead ->
                ConfettiPiece(seed, column, row, 1, LinearForm.constant(Int.MAX_VALUE / 2 + lead))
            }
        return mixed(3 to hashed, 2 to formed, 1 to level)
    }

    /** Generates ranges that start in the first half of a side and are at least half a side long; rarely empty ones. */
    private fun range(side: Int): Arbitrary<IntRange> = mixed(
        29 to Combinators.combine(ints(0, side - 1), ints(1, side)).`as` { from, length ->
            from / 2..minOf(side, from / 2 + (side + length) / 2)
        },
        1 to ints(0, side).map { it..it },
    )
}
