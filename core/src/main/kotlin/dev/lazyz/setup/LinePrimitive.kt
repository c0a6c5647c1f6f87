package dev.lazyz.setup

import dev.lazyz.Fragment
import dev.lazyz.HeapLayout
import dev.lazyz.LinearForm
import dev.lazyz.Shader
import dev.lazyz.Spans
import dev.lazyz.raster.RowHull
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive
import kotlin.math.ceil
import kotlin.math.round

/**
 * A line segment on the raster: a quad around its snapped ends, and the sample nearest to each end (contract rule
 * 2.10).
 *
 * Depth and attributes are functions of the position along the segment. Beyond an end they are constant.
 *
 * @param segment number of the segment in [strokes]
 * @param half half the width, grid steps
 * @param x0 column position of the first end on the 1/256 pixel grid; y0 its row position; x1 and y1 of the second end
 * @param z0 depth of the first end; z1 of the second
 * @param over0 1/w of the first end; over1 of the second
 * @param from position of the first end on the unclipped segment: 0 unless it has been clipped
 * @param until position of the second end on the unclipped segment: 1 unless it has been clipped
 */
internal class LinePrimitive(
    private val strokes: LineStrokes,
    private val segment: Int,
    half: Int,
    private val x0: Int,
    private val y0: Int,
    private val z0: Int,
    private val x1: Int,
    private val y1: Int,
    private val z1: Int,
    private val over0: Double,
    private val over1: Double,
    private val from: Double,
    private val until: Double,
) : AttributedPrimitive {
    private val runX: Long get() = (x1 - x0).toLong()
    private val runY: Long get() = (y1 - y0).toLong()

    /** Square of the length, square grid steps. */
    private val square: Long get() = runX * runX + runY * runY

    /**
     * A vector of half the width in the direction of the segment, grid steps. Rotated by 90 degrees, it points across
     * the segment.
     */
    private val alongX: Int
    private val alongY: Int

    init {
        val length = StrictMath.sqrt(square.toDouble())
        alongX = if (square == 0L) half else share(half, runX, length)
        alongY = if (square == 0L) 0 else share(half, runY, length)
    }

    override val rowStart: Int
    override val rowEnd: Int
    override val columnStart: Int
    override val columnEnd: Int

    init {
        // The quad extends beyond the ends by at most the sum of both components, and the sample of an end by half a
        // pixel
        val reach = maxOf(Math.abs(alongX) + Math.abs(alongY), ScreenGrid.CENTER)
        rowStart = maxOf(ScreenGrid.firstSample(minOf(y0, y1) - reach), 0)
        rowEnd = minOf(ScreenGrid.firstSample(maxOf(y0, y1) + reach), strokes.raster.height)
        columnStart = maxOf(ScreenGrid.firstSample(minOf(x0, x1) - reach), 0)
        columnEnd = minOf(ScreenGrid.firstSample(maxOf(x0, x1) + reach), strokes.raster.width)
    }

    private val isLevel: Boolean get() = z0 == z1 || square == 0L
    override val depthForm: LinearForm? get() = if (isLevel) LinearForm.constant(z0) else null
    override val leastDepth: Int get() = if (isLevel) z0 else minOf(z0, z1)
    override val greatestDepth: Int get() = if (isLevel) z0 else maxOf(z0, z1)
    override val isTranslucent: Boolean get() = strokes.isTranslucent(segment)
    override val shader: Shader get() = strokes.shader
    override val heldBytes: Long get() = HeapLayout.LINE

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        val row = RowHull(y)
        val ax = x0 - alongX - alongY
        val ay = y0 - alongY + alongX
        val bx = x1 + alongX - alongY
        val by = y1 + alongY + alongX
        val cx = x1 + alongX + alongY
        val cy = y1 + alongY - alongX
        val dx = x0 - alongX + alongY
        val dy = y0 - alongY - alongX
        row.addEdge(ax, ay, bx, by)
        row.addEdge(bx, by, cx, cy)
        row.addEdge(cx, cy, dx, dy)
        row.addEdge(dx, dy, ax, ay)
        row.endShape()
        row.addPixel(x0, y0)
        row.addPixel(x1, y1)
        val start = maxOf(row.start, columnStart)
        val end = minOf(row.end, columnEnd)
        if (start < end) spans.add(start, end)
    }

    override fun depth(x: Int, y: Int): Int =
        if (isLevel) z0 else z0 + round(along(x, y) * (z1.toDouble() - z0.toDouble())).toInt()

    /**
     * Returns the position of a sample along the segment: 0 at the first end and before it, 1 at the second end and
     * beyond.
     */
    private fun along(x: Int, y: Int): Double {
        val right = (x * ScreenGrid.STEPS + ScreenGrid.CENTER - x0).toLong()
        val down = (y * ScreenGrid.STEPS + ScreenGrid.CENTER - y0).toLong()
        val product = runX * right + runY * down
        if (product <= 0L) return 0.0
        val whole = square
        return if (product >= whole) 1.0 else product.toDouble() / whole.toDouble()
    }

    override fun attributes(fragment: Fragment) {
        // Perspective-correct (rule 3.6)
        val t = along(fragment.x, fragment.y)
        val weight0 = (1.0 - t) * over0
        val weight1 = t * over1
        val place = from + weight1 / (weight0 + weight1) * (until - from)
        strokes.attributes(segment, place, fragment)
    }

    override fun toString(): String = "LinePrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd)"

    private companion object {
        /** Returns the component of [half] in one direction, rounded away from zero so that no line is too thin. */
        fun share(half: Int, run: Long, length: Double): Int {
            val size = ceil(half.toDouble() * Math.abs(run).toDouble() / length).toInt()
            return if (run < 0L) -size else size
        }
    }
}
