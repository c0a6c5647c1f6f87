package dev.lazyz.strategies.tiled.raster

import dev.lazyz.DepthTest
import dev.lazyz.raster.ScreenGrid
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The rows of a triangle have the samples at which no edge function is negative. */
class TriangleRowsTest {
    private val random = Random(65)
    private var covered = 0
    private var level = 0
    private var widest = 0

    @Test
    fun rowsAreThoseOfTheEdgeFunctions() {
        val forms = TriangleForms(DepthTest.LESS)
        val rows = TriangleRows()
        repeat(6_000) { number ->
            val side = if (number % 2 == 0) ScreenGrid.STEPS * TriangleRows.MOST - 1 else 1 + random.nextInt(5_000)
            // On the grid of samples, edges run through samples
            val unit = if (number % 3 == 0) ScreenGrid.CENTER else 1
            val x = ScreenGrid.STEPS * (random.nextInt(1 shl 18) - (1 shl 17))
            val y = ScreenGrid.STEPS * (random.nextInt(1 shl 18) - (1 shl 17))
            val (ax, bx, cx) = List(3) { x + corner(side) / unit * unit }
            val (ay, b, cy) = List(3) { y + corner(side) / unit * unit }
            val by = if (random.nextInt(4) == 0) ay else b
            if (ay == by) level++
            ScreenGrid.bounds(ax, ay, bx, by, cx, cy) { columnStart, rowStart, columnEnd, rowEnd ->
                if (columnStart >= columnEnd || rowStart >= rowEnd) return@repeat
                // A tile that begins somewhere in the bounds, or before them
                val tileX = columnStart - 20 + random.nextInt(30)
                val tileY = rowStart - 20 + random.nextInt(30)
                val left = maxOf(columnStart, tileX) - tileX
                val top = maxOf(rowStart, tileY) - tileY
                val right = columnEnd - tileX
                forms.edges(ax, ay, bx, by, cx, cy, tileX, tileY)
                widest = maxOf(widest, right - left)
                rows.begin(forms, left, right, top)
                for (row in top until rowEnd - tileY) {
                    val expected = (left until right).filter {
                        forms.at0(it, row) or forms.at1(it, row) or forms.at2(it, row) >= 0
                    }
                    val actual = (rows.start until rows.end).toList()
                    assertEquals(expected, actual) { "triangle $number, row $row" }
                    covered += actual.size
                    rows.next()
                }
            }
        }
        assertTrue(covered > 1_000_000 && level > 1_000 && widest == TriangleRows.MOST) { "$covered, $level, $widest" }
    }

    private fun corner(side: Int): Int = when (random.nextInt(4)) {
        0 -> 0
        1 -> side - 1
        else -> random.nextInt(side)
    }
}
