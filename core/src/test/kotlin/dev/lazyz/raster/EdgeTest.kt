package dev.lazyz.raster

import dev.lazyz.FillRule
import dev.lazyz.GridPoint
import dev.lazyz.Spans
import dev.lazyz.setup.GuardBandTriangles
import java.math.BigInteger
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EdgeTest {
    @Test
    fun theFunctionIsExactUpToTheGuardBand() {
        val guard = ScreenGrid.GUARD * ScreenGrid.STEPS
        val places = listOf(-guard, 1 - guard, -1, 0, 1, guard - 1, guard)
        val points = places.flatMap { x -> places.map { y -> GridPoint(x, y) } }
        for (from in points) {
            for (to in points) {
                for (at in listOf(GridPoint(guard, guard), GridPoint(guard, -guard), GridPoint(128, 128))) {
                    val expected = exact(to.x - from.x, at.y - from.y) - exact(to.y - from.y, at.x - from.x)
                    assertEquals(expected, BigInteger.valueOf(function(from, to, at)))
                }
            }
        }
    }

    private fun exact(a: Int, b: Int): BigInteger = BigInteger.valueOf(a.toLong()) * BigInteger.valueOf(b.toLong())

    /** [EdgeTable] finds coverage by crossings of rows; the edge function and the owners of edges say the same. */
    @Test
    fun rule_2_2_edgesThatOwnTheirSamplesAreTheLeftAndUpperOnes() {
        val random = Random(22)
        var onEdges = 0
        repeat(20_000) {
            val column = random.nextInt(SIDE)
            val row = random.nextInt(SIDE)
            val near = List(3) { GridPoint(128 * (random.nextInt(9) - 4 + 2 * column), 128 * (random.nextInt(9) - 4)) }
            val triangle = if (it % 2 == 0) near else GuardBandTriangles.around(random, column, row) ?: near
            val sampleY = if (it % 2 == 0) 0 else row
            val (a, b, c) = triangle.clockwise() ?: return@repeat
            val sample = GridPoint(256 * column + 128, 256 * sampleY + 128)
            val edges = listOf(a to b, b to c, c to a)
            if (edges.any { (from, to) -> function(from, to, sample) == 0L }) onEdges++
            val isInside = edges.all { (from, to) ->
                val value = function(from, to, sample)
                value > 0 || (value == 0L && Edge.isTopLeft(to.x - from.x, to.y - from.y))
            }
            assertEquals(covers(listOf(a, b, c), column, sampleY), isInside) { "$a $b $c at $column, $sampleY" }
        }
        assertTrue(onEdges > 1000) { "$onEdges" }
    }

    private fun List<GridPoint>.clockwise(): List<GridPoint>? {
        val (a, b, c) = this
        val area = function(a, b, c)
        return if (area == 0L) {
            null
        } else if (area > 0) {
            this
        } else {
            listOf(a, c, b)
        }
    }

    private fun function(from: GridPoint, to: GridPoint, at: GridPoint): Long =
        Edge.function(from.x, from.y, to.x, to.y, at.x, at.y)

    private fun covers(triangle: List<GridPoint>, column: Int, row: Int): Boolean {
        val xs = IntArray(3) { triangle[it].x }
        val ys = IntArray(3) { triangle[it].y }
        val spans = Spans()
        val table = EdgeTable(xs, ys, intArrayOf(3), FillRule.NON_ZERO, SIDE, SIDE)
        table.spans(row, spans)
        return (0 until spans.count).any { column in spans.start(it) until spans.end(it) }
    }

    private companion object {
        const val SIDE = 262_144
    }
}
