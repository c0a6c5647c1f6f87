package dev.lazyz.raster

import dev.lazyz.geometry.FillRule
import java.math.BigDecimal
import java.math.BigInteger
import java.math.RoundingMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 1.2 to 1.4 and 2.1: the grid, and where edges cross rows. */
class ScreenGridProperties {
    @Property(seed = "1995", tries = 1000)
    fun rule_1_3_positionsRoundHalfUp(@ForAll @IntRange(min = -268435456, max = 268435456) half: Int) {
        // Every other value is halfway between two grid lines
        val expected = BigDecimal(half).divide(BigDecimal(2)).setScale(0, RoundingMode.HALF_UP)
        val halfUp = if (half < 0 && half % 2 != 0) expected.add(BigDecimal.ONE) else expected
        assertEquals(halfUp.toInt(), ScreenGrid.snap(half / 512.0))
    }

    @Property(seed = "1995", tries = 1000)
    fun rule_1_3_positionsAreNearest(@ForAll pixels: Double) {
        val snapped = ScreenGrid.snap(pixels)
        val limit = 1 shl 27
        if (Math.abs(pixels) <= 1 shl 19) {
            assertTrue(Math.abs(snapped - pixels * 256) <= 0.5) { "$pixels snapped to $snapped" }
        } else {
            assertEquals(if (pixels > 0) limit else -limit, snapped)
        }
    }

    @Property(seed = "1995", tries = 1000)
    fun rule_1_2_firstSampleIsAtOrAfter(@ForAll @IntRange(min = -134217728, max = 134217728) grid: Int) {
        val first = ScreenGrid.firstSample(grid)
        assertTrue(256L * first + 128 >= grid && 256L * (first - 1) + 128 < grid) { "$grid: $first" }
    }

    @Property(seed = "1995", tries = 3000)
    fun rule_2_1_crossingsAreRoundedUpExactly(
        @ForAll @IntRange(min = -134217728, max = 134217728) x0: Int,
        @ForAll @IntRange(min = -134217728, max = 134217728) y0: Int,
        @ForAll @IntRange(min = -134217728, max = 134217728) x1: Int,
        @ForAll @IntRange(min = -134217728, max = 134217728) y1: Int,
        @ForAll @IntRange(min = 0, max = 262143) someRow: Int,
    ) {
        // Forth and back: two edges with opposite windings
        val edges = EdgeTable(intArrayOf(x0, x1), intArrayOf(y0, y1), intArrayOf(2), FillRule.NON_ZERO, 262144, 262144)
        if (edges.count == 0) return
        val row = edges.rowStart + someRow % (edges.rowEnd - edges.rowStart)
        assertTrue(256L * row + 128 >= minOf(y0, y1) && 256L * row + 128 < maxOf(y0, y1)) { "row $row" }
        assertEquals(0, edges.winding(0) + edges.winding(1))

        // The smallest x with (256 x + 128 - x0) dy >= (256 row + 128 - y0) dx, in big integers
        val dx = BigInteger.valueOf(x1.toLong() - x0)
        val dy = BigInteger.valueOf(y1.toLong() - y0)
        val sign = BigInteger.valueOf(dy.signum().toLong())
        for (edge in 0 until 2) {
            val column = edges.column(edge, row).toLong()
            val right = BigInteger.valueOf(256L * row + 128 - y0) * dx * sign
            assertTrue(BigInteger.valueOf(256 * column + 128 - x0) * dy * sign >= right) { "column $column" }
            assertTrue(BigInteger.valueOf(256 * (column - 1) + 128 - x0) * dy * sign < right) { "column $column" }
        }
    }
}
