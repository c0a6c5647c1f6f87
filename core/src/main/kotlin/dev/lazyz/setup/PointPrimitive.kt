package dev.lazyz.setup

import dev.lazyz.Fragment
import dev.lazyz.HeapLayout
import dev.lazyz.LinearForm
import dev.lazyz.Shader
import dev.lazyz.Spans
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive

/**
 * A point on the raster: a square around its snapped vertex, with constant depth (contract rule 2.9).
 *
 * A frame can have tens of millions of points, so a point has only four numbers and a reference to its [cloud]: 32
 * bytes.
 *
 * @param number number of the point in the cloud
 * @param x column position of the vertex on the 1/256 pixel grid
 * @param y row position of the vertex on the 1/256 pixel grid
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
    override val shader: Shader get() = cloud.shader
    override val heldBytes: Long get() = HeapLayout.POINT

    /** Whether the point covers any sample. */
    val isVisible: Boolean get() = rowStart < rowEnd && columnStart < columnEnd

    override fun spans(y: Int, spans: Spans) {
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun attributes(fragment: Fragment): Unit = cloud.attributes(number, fragment)

    override fun toString(): String =
        "PointPrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd, depth $depth)"
}
