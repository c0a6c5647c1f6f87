package dev.lazyz.raster

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ReferenceTriangleTest {
    @Test
    fun sizeIsTwiceTheAreaWhicheverWayTheVerticesRun() {
        assertEquals(256L * 512, ReferenceTriangle(0, 0, 256, 0, 0, 512).size)
        assertEquals(256L * 512, ReferenceTriangle(0, 0, 0, 512, 256, 0).size)
        assertEquals(0, ReferenceTriangle(0, 0, 1, 1, 2, 2).size)
    }

    @Test
    fun rule_3_4_aQuarterOfTheRangeFromASampleToTheNextIsTooSteep() {
        // One pixel to the right or downward; increasing or decreasing depth
        val quarter = 1 shl 29
        for ((x, y) in listOf(256 to 0, 0 to 256)) {
            val t = ReferenceTriangle(0, 0, x, y, y, x)
            for (depth in listOf(0, 1 shl 30)) {
                for (step in listOf(quarter, -quarter)) {
                    if (depth + step < 0) continue
                    val steep = t.form(depth, depth + step, depth)
                    assertEquals(listOf(0L, 0L), listOf(steep.dx, steep.dy))
                    assertEquals(depth, (steep.at(5, 7) shr 32).toInt())
                    val less = step - Integer.signum(step)
                    val gentle = t.form(depth, depth + less, depth)
                    val (dx, dy) = if (x > 0) less to 0 else 0 to less
                    assertEquals(listOf(dx.toLong() shl 32, dy.toLong() shl 32), listOf(gentle.dx, gentle.dy))
                }
            }
        }
    }
}
