package dev.lazyz.strategies.tiled.raster

import dev.lazyz.GridPoint
import dev.lazyz.raster.Edge
import dev.lazyz.raster.ScreenGrid
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The coverage of small triangles in 32 bits and without branches is what the edge functions say. */
class SmallCoverageTest {
    private val random = Random(33)

    @Test
    fun rule_2_2_bitsAreTheSamplesInsideAllEdges() {
        val guard = ScreenGrid.GUARD * ScreenGrid.STEPS
        val widest = SmallCoverage.MOST * ScreenGrid.STEPS
        var covered = 0
        for (origin in listOf(0, 5 * ScreenGrid.STEPS, -guard, guard - widest)) {
            for (reach in listOf(1, ScreenGrid.STEPS, 3 * ScreenGrid.STEPS, widest)) {
                repeat(4000) {
                    // Every other triangle has vertices on samples and between them, so that edges pass through samples
                    val step = if (it % 2 == 0) 1 else ScreenGrid.CENTER
                    val corners = List(3) { GridPoint(place(origin, reach, step), place(origin, reach, step)) }
                    covered += check(corners)
                }
            }
        }
        assertTrue(covered > 10_000) { "$covered" }
    }

    /** Returns a place at most [reach] grid steps after [origin], often one of both ends. */
    private fun place(origin: Int, reach: Int, step: Int): Int = when (random.nextInt(8)) {
        0 -> origin
        1 -> origin + reach
        else -> origin + random.nextInt(reach / step + 1) * step
    }

    /** Compares a square that the bounds of the triangle reach; returns how many samples are covered. */
    private fun check(corners: List<GridPoint>): Int {
        val (a, b, c) = corners
        val left = ScreenGrid.firstSample(corners.minOf { it.x })
        val top = ScreenGrid.firstSample(corners.minOf { it.y })
        val column = left + random.nextInt(maxOf(1, ScreenGrid.firstSample(corners.maxOf { it.x }) - left))
        val row = top + random.nextInt(maxOf(1, ScreenGrid.firstSample(corners.maxOf { it.y }) - top))
        var expected = 0
        for (place in 0 until SmallCoverage.SIDE * SmallCoverage.SIDE) {
            val x = (column + SmallCoverage.column(place)) * ScreenGrid.STEPS + ScreenGrid.CENTER
            val y = (row + SmallCoverage.row(place)) * ScreenGrid.STEPS + ScreenGrid.CENTER
            if (isInside(corners, GridPoint(x, y))) expected = expected or (1 shl place)
        }
        val actual = SmallCoverage.of(a.x, a.y, b.x, b.y, c.x, c.y, column, row)
        assertEquals(expected, actual) { "$corners, square at $column, $row" }
        return Integer.bitCount(actual)
    }

    private fun isInside(corners: List<GridPoint>, sample: GridPoint): Boolean {
        val (a, b, c) = corners
        val area = function(a, b, c)
        val clockwise = if (area < 0) listOf(a to c, c to b, b to a) else listOf(a to b, b to c, c to a)
        return area != 0L && clockwise.all { (from, to) ->
            val value = function(from, to, sample)
            value > 0 || (value == 0L && Edge.isTopLeft(to.x - from.x, to.y - from.y))
        }
    }

    private fun function(from: GridPoint, to: GridPoint, at: GridPoint): Long =
        Edge.function(from.x, from.y, to.x, to.y, at.x, at.y)
}
