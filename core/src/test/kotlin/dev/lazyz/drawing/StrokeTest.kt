package dev.lazyz.drawing

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.raster.Edge
import dev.lazyz.spi.Spans
import java.util.Random
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.sign
import kotlin.math.sqrt
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Strokes, sample by sample, and dashes, by their formulas in the contract. */
class StrokeTest {
    private val raster = Raster(24, 24)

    @Test
    fun rule_10_3_strokesCoverTheirQuadAndTwoDiscs() {
        val random = Random(10)
        repeat(400) { round ->
            // Also on samples and on pixels' sides, horizontal, vertical, and without length
            val step = intArrayOf(1, 64, 128, 256)[round % 4]
            val (x0, y0, x1, y1) = List(4) { random.nextInt(40 * 256 / step) * step - 8 * 256 }
            val isPoint = round % 50 == 0
            val endX = if (round % 5 == 0 || isPoint) x0 else x1
            val endY = if (round % 7 == 0 || isPoint) y0 else y1
            val width = 0.3 + round % 9
            val half = maxOf(floor(width * 128 + 0.5).toInt(), 128)
            val stroke = Stroke(Pen(raster, Rgba.BLACK, 0, width), x0, y0, endX, endY)
            for (y in 0 until raster.height) {
                val covered = (0 until raster.width).filter { covers(x0, y0, endX, endY, half, it, y) }
                val spans = Spans()
                stroke.spans(y, spans)
                val expected = if (covered.isEmpty()) "[]" else "[${covered.first()}..<${covered.last() + 1}]"
                assertEquals(expected, "$spans") { "row $y of ($x0, $y0) to ($endX, $endY), half $half" }
            }
        }
    }

    /** Whether the quad of the line or a disc at an end covers sample ([x], [y]). */
    private fun covers(x0: Int, y0: Int, x1: Int, y1: Int, half: Int, x: Int, y: Int): Boolean {
        val sampleX = 256 * x + 128
        val sampleY = 256 * y + 128
        for ((centerX, centerY) in listOf(x0 to y0, x1 to y1)) {
            val down = sampleY - centerY
            if (down < -half || down >= half) continue
            val reach = floor(sqrt(half.toDouble() * half - down.toDouble() * down)).toInt()
            if (sampleX >= centerX - reach && sampleX < centerX + reach) return true
        }
        val length = sqrt((x1 - x0).toDouble() * (x1 - x0) + (y1 - y0).toDouble() * (y1 - y0))
        if (length == 0.0) return false
        fun outward(size: Double) = (sign(size) * ceil(abs(size))).toInt()
        val vx = outward(half * -(y1 - y0) / length)
        val vy = outward(half * (x1 - x0) / length)
        val corners = listOf(x0 - vx to y0 - vy, x1 - vx to y1 - vy, x1 + vx to y1 + vy, x0 + vx to y0 + vy)
        return corners.indices.all { i ->
            val (fromX, fromY) = corners[i]
            val (toX, toY) = corners[(i + 1) % 4]
            val side = Edge.function(fromX, fromY, toX, toY, sampleX, sampleY)
            side > 0 || (side == 0L && Edge.isTopLeft(toX - fromX, toY - fromY))
        }
    }

    @Test
    fun rule_10_3_dashesFillTheLine() {
        // 5 and 3.5 pixels a unit of width. 13.5 and 22.0 fit exactly; a half is rounded to even
        val gaps = mapOf(
            1.0 to 0, 9.24 to 0, 9.25 to 0, 9.26 to 1, 13.5 to 1, 17.75 to 2, 22.0 to 2, 26.25 to 2, 1000.0 to 117,
        )
        for ((length, count) in gaps) {
            val dashes = ArrayList<DoubleArray>()
            Dashes(5.0, 3.5).forEach(doubleArrayOf(2.0, 7.0, 2.0 + length, 7.0)) { dashes += it }
            assertEquals(count + 1, dashes.size) { "$length" }
            val scale = if (count == 0) length / 5.0 else length / (5.0 * (count + 1) + 3.5 * count)
            for ((i, dash) in dashes.withIndex()) {
                assertEquals(2.0 + i * 8.5 * scale, dash[0], 1e-9)
                assertEquals(dash[0] + 5.0 * scale, dash[dash.size - 2], 1e-9)
            }
            assertEquals(2.0 + length, dashes.last().let { it[it.size - 2] }, 1e-9)
        }
    }

    @Test
    fun rule_10_3_dashesFollowTheLineAroundCorners() {
        val dashes = ArrayList<DoubleArray>()
        Dashes(5.0, 3.5).forEach(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 10.5)) { dashes += it }
        val expected = listOf(listOf(0.0, 0.0, 3.0, 0.0, 3.0, 2.0), listOf(3.0, 5.5, 3.0, 10.5))
        assertEquals(expected, dashes.map { it.toList() })
    }

    @Test
    fun rule_10_3_segmentsWithoutLengthAreLeftOut() {
        val pen = Pen(raster, Rgba.BLACK, 0, 1.0)
        assertEquals(1, pen.strokes(doubleArrayOf(3.0, 3.0, 3.001, 3.001)).size, "a line without length is a disc")
        assertEquals(1, pen.strokes(doubleArrayOf(3.0, 3.0, 9.0, 3.0, 9.001, 3.0)).size)
        assertEquals(2, pen.strokes(doubleArrayOf(3.0, 3.0, 9.0, 3.0, 9.5, 3.0)).size)
    }
}
