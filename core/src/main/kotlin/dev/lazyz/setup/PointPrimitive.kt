package dev.lazyz.setup

import dev.lazyz.Fragment
import dev.lazyz.LinearForm
import dev.lazyz.Spans
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive

/**
 * A point on the raster: a square around its snapped vertex, of one depth (contract rule 2.9).
 *
 * There may be tens of millions of them, so this is four numbers and what it shares with its [cloud]: 32 bytes.
 *
 * @param number of the point within the cloud
 * @param x column position of the vertex on the 1/256 pixel grid
 * @param y row position, likewise
 */
internal class PointPrimitive(
    private val cloud: PointCloud,
    private val number: Int,
    private val x: Int,
    private val y: Int,
    private val depth: Int,
) : AttributedPrimitive {
    override val rowStart: Int get() = maxOf(ScreenGrid.firstSample(y - cloud.half), 0)
    override val rowEnd: Int get() = minOf(ScreenGrid.firstSample(y + cloud.half), cloud.raster.height)
    override val columnStart: Int get() = maxOf(ScreenGrid.firstSample(x - cloud.half), 0)
    override val columnEnd: Int get() = minOf(ScreenGrid.firstSample(x + cloud.half), cloud.raster.width)
    override val depthForm: LinearForm get() = LinearForm.constant(depth)
    override val leastDepth: Int get() = depth
    override val greatestDepth: Int get() = depth
    override val isTranslucent: Boolean get() = cloud.isTranslucent(number)
    override val heldBytes: Long get() = BYTES

    /** Whether it covers a sample. */
    val isVisible: Boolean get() = rowStart < rowEnd && columnStart < columnEnd

    override fun spans(y: Int, spans: Spans) {
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        attributes(fragment)
        cloud.shader.shade(fragment)
    }

    override fun attributes(fragment: Fragment): Unit = cloud.attributes(number, fragment)

    override fun toString(): String =
        "PointPrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd, depth $depth)"

    private companion object {
        /** A header, a reference and four numbers. */
        const val BYTES = 32L
    }
}
