package dev.lazyz.raster

import dev.lazyz.GridPoint
import java.math.BigInteger
import org.junit.jupiter.api.Assertions.assertEquals
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

    private fun function(from: GridPoint, to: GridPoint, at: GridPoint): Long =
        Edge.function(from.x, from.y, to.x, to.y, at.x, at.y)
}
