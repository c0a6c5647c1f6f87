package dev.lazyz.drawing.strokes

import dev.lazyz.Fragment
import dev.lazyz.HeapLayout
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Spans
import dev.lazyz.raster.RowHull
import dev.lazyz.raster.ScreenGrid
import kotlin.math.ceil
import kotlin.math.floor

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
