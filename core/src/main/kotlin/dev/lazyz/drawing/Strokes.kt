package dev.lazyz.drawing

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.raster.RowHull
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Spans
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.round

/**
 * A straight line with round ends on the raster, in front of all surfaces: a quad around its snapped ends, and a disc
 * at each of them. Coverage is exact: the samples of a row from the first to the last that one of the three covers, by
 * the rules of the contract for edges. A line of the width of a sample or more has no gaps. Immutable and thread safe.
 *
 * @param pen what all strokes of a drawing share
 * @param x0 column position of the first end on the 1/256 pixel grid; y0 its row position; x1 and y1 of the second end
 */
internal class Stroke(
    private val pen: Pen,
    private val x0: Int,
    private val y0: Int,
    private val x1: Int,
    private val y1: Int,
) : Primitive {
    override val rowStart: Int get() = maxOf(ScreenGrid.firstSample(minOf(y0, y1) - pen.half), 0)
    override val rowEnd: Int get() = minOf(ScreenGrid.firstSample(maxOf(y0, y1) + pen.half), pen.raster.height)
    override val columnStart: Int get() = maxOf(ScreenGrid.firstSample(minOf(x0, x1) - pen.half), 0)
    override val columnEnd: Int get() = minOf(ScreenGrid.firstSample(maxOf(x0, x1) + pen.half), pen.raster.width)
    override val depthForm: LinearForm get() = LinearForm.constant(pen.depth)
    override val leastDepth: Int get() = pen.depth
    override val greatestDepth: Int get() = pen.depth
    override val heldBytes: Long get() = HeapLayout.POINT

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        val row = RowHull(y)
        addQuad(row)
        row.endShape()
        addDisc(row, y, x0, y0)
        addDisc(row, y, x1, y1)
        val start = maxOf(row.start, columnStart)
        val end = minOf(row.end, columnEnd)
        if (start < end) spans.add(start, end)
    }

    private fun addQuad(row: RowHull) {
        val runX = (x1 - x0).toDouble()
        val runY = (y1 - y0).toDouble()
        val length = StrictMath.sqrt(runX * runX + runY * runY)
        if (length == 0.0) return

        // A vector across the line, rounded away from zero so that no line is too thin
        val acrossX = outward(pen.half * -runY / length)
        val acrossY = outward(pen.half * runX / length)
        row.addEdge(x0 + acrossX, y0 + acrossY, x1 + acrossX, y1 + acrossY)
        row.addEdge(x1 + acrossX, y1 + acrossY, x1 - acrossX, y1 - acrossY)
        row.addEdge(x1 - acrossX, y1 - acrossY, x0 - acrossX, y0 - acrossY)
        row.addEdge(x0 - acrossX, y0 - acrossY, x0 + acrossX, y0 + acrossY)
    }

    private fun outward(size: Double): Int =
        if (size < 0.0) floor(size).toInt() else ceil(size).toInt()

    private fun addDisc(row: RowHull, y: Int, centerX: Int, centerY: Int) {
        val down = y * ScreenGrid.STEPS + ScreenGrid.CENTER - centerY
        if (down < -pen.half || down >= pen.half) return
        val half = pen.half.toDouble()
        val reach = StrictMath.sqrt(half * half - down.toDouble() * down).toInt()
        row.addColumns(ScreenGrid.firstSample(centerX - reach), ScreenGrid.firstSample(centerX + reach))
    }

    override fun depth(x: Int, y: Int): Int = pen.depth

    override fun shade(fragment: Fragment): Unit =
        fragment.setColor(pen.color.red, pen.color.green, pen.color.blue)

    override fun toString(): String = "Stroke(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd)"
}

/**
 * What all strokes of one kind share. Immutable.
 *
 * @property depth depth of all strokes
 * @param width pixels
 */
internal class Pen(val raster: Raster, val color: Rgba, val depth: Int, width: Double) {
    /** Half the width, grid steps. */
    val half: Int = ScreenGrid.half(width)

    /** Returns the strokes along a polyline, given as x and y of its points in turn, pixels. */
    fun strokes(line: DoubleArray): List<Stroke> {
        val strokes = ArrayList<Stroke>(line.size / 2)
        var x = ScreenGrid.snap(line[0])
        var y = ScreenGrid.snap(line[1])
        for (i in 2 until line.size step 2) {
            val nextX = ScreenGrid.snap(line[i])
            val nextY = ScreenGrid.snap(line[i + 1])
            if ((nextX == x && nextY == y) && (i < line.size - 2 || strokes.isNotEmpty())) continue
            strokes += Stroke(this, x, y, nextX, nextY)
            x = nextX
            y = nextY
        }
        return strokes
    }
}

/**
 * Divides polylines into dashes of about the same length. A polyline begins and ends with a dash, so that corners of
 * dashed lines are closed. Immutable.
 *
 * @param dash length of a dash, pixels
 * @param gap length of a gap, pixels
 */
internal class Dashes(private val dash: Double, private val gap: Double) {
    /** Calls [action] with the points of each dash of [line], x and y in turn. */
    fun forEach(line: DoubleArray, action: (DoubleArray) -> Unit) {
        val length = (2 until line.size step 2).sumOf { step(line, it) }
        val gaps = round((length - dash) / (dash + gap))
        if (gaps < 1.0) return action(line)

        // Stretch or shrink the pattern, so that it fits
        val scale = length / ((gaps + 1) * dash + gaps * gap)
        val period = scale * (dash + gap)
        for (number in 0..gaps.toInt()) part(line, number * period, number * period + scale * dash)?.let(action)
    }

    /** Returns the part of [line] between two places, given as distances from its start. */
    private fun part(line: DoubleArray, from: Double, until: Double): DoubleArray? {
        val points = ArrayList<Double>()
        var at = 0.0
        for (i in 2 until line.size step 2) {
            val next = at + step(line, i)
            if (next > from && at < until && next > at) {
                if (points.isEmpty()) addPoint(points, line, i, maxOf(from - at, 0.0) / (next - at))
                addPoint(points, line, i, minOf(until - at, next - at) / (next - at))
            }
            at = next
        }
        return points.takeIf { it.isNotEmpty() }?.toDoubleArray()
    }

    private fun addPoint(points: MutableList<Double>, line: DoubleArray, i: Int, t: Double) {
        points += line[i - 2] + t * (line[i] - line[i - 2])
        points += line[i - 1] + t * (line[i + 1] - line[i - 1])
    }

    private fun step(line: DoubleArray, i: Int): Double {
        val x = line[i] - line[i - 2]
        val y = line[i + 1] - line[i - 1]
        return StrictMath.sqrt(x * x + y * y)
    }
}
