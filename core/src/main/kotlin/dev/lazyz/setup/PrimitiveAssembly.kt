package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.geometry.FillRule
import dev.lazyz.raster.Edge
import dev.lazyz.raster.EdgeTable
import dev.lazyz.raster.ReferenceTriangle
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import kotlin.math.round

/**
 * The last step of set-up: converts snapped vertices to a primitive (contract rules 2 to 4).
 *
 * @param vertices the vertices with their attributes
 * @param selection the contours' vertices in [vertices], one contour after the other
 * @param contourEnds for each contour, the index after its last vertex
 * @param xs column positions on the 1/256 pixel grid, in the order of [selection]
 * @param ys row positions of the same vertices
 * @param depths depths of the same vertices
 */
internal class PrimitiveAssembly(
    private val vertices: Vertices,
    private val selection: IntArray,
    private val contourEnds: IntArray,
    private val xs: IntArray,
    private val ys: IntArray,
    private val depths: IntArray,
) {
    fun primitive(
        raster: Raster,
        fillRule: FillRule,
        shader: Shader,
        fields: Int,
        normalSign: Double,
        isTranslucent: Boolean,
    ): AttributedPrimitive? {
        // Bounds, and edges that cross rows; without edges nothing is covered
        val columnStart = maxOf(ScreenGrid.firstSample(xs.min()), 0)
        val columnEnd = minOf(ScreenGrid.firstSample(xs.max()), raster.width)
        if (columnStart >= columnEnd) return null
        val edges = EdgeTable(xs, ys, contourEnds, fillRule, raster.width, raster.height)
        if (edges.count == 0) return null

        // The forms pass through three vertices that are far apart
        val (a, b, c) = referenceCorners()
        val reference = ReferenceTriangle(xs[a], ys[a], xs[b], ys[b], xs[c], ys[c])
        val depthForm = depthForm(reference, a, b, c)
        val corners = intArrayOf(selection[a], selection[b], selection[c])
        val isLevel = depthForm.dx == 0L && depthForm.dy == 0L
        val depthsOfForm = if (isLevel) intArrayOf(depths[a]) else cornerDepths(reference, a, b, c)
        return PlanarPrimitive(
            edges, columnStart, columnEnd, depthForm, isTriangle, reference, vertices, corners, leastInverseW(),
            normalSign, fields, shader,
            maxOf(depthsOfForm.min() - 1, 0), minOf(depthsOfForm.max(), Int.MAX_VALUE - 1) + 1, isTranslucent,
        )
    }

    /**
     * Returns three indices into [selection]. For a triangle, all three vertices. For more vertices: the first, the one
     * farthest from it, and the one farthest from the line through both. With these, no vertex has a barycentric
     * coordinate above 4 in absolute value, so planes and attributes are never extrapolated far.
     */
    private fun referenceCorners(): IntArray {
        if (xs.size == 3) return intArrayOf(0, 1, 2)
        val second = xs.indices.maxBy {
            val dx = (xs[it] - xs[0]).toLong()
            val dy = (ys[it] - ys[0]).toLong()
            dx * dx + dy * dy
        }
        val third = xs.indices.maxBy {
            Math.abs(Edge.function(xs[0], ys[0], xs[second], ys[second], xs[it], ys[it]))
        }
        return intArrayOf(0, second, third)
    }

    private val isTriangle: Boolean get() = xs.size == 3 && contourEnds.size == 1

    /** The smallest 1/w of the vertices, or 0 for a triangle. */
    private fun leastInverseW(): Double =
        if (isTriangle) 0.0 else selection.minOf { 1.0 / vertices.get(it, Vertices.W) }

    /** Depth of the plane at every vertex, rounded. [depthForm] ensures that it is in the range of depths. */
    private fun cornerDepths(reference: ReferenceTriangle, a: Int, b: Int, c: Int): IntArray =
        if (xs.size == 3) {
            depths
        } else {
            IntArray(xs.size) {
                round(reference.valueAt(xs[it], ys[it], depths[a], depths[b], depths[c])).toInt()
            }
        }

    /**
     * The linear form of depth. It is constant if the plane is within a unit of the end of the range of depths (rule
     * 3.4).
     */
    private fun depthForm(reference: ReferenceTriangle, a: Int, b: Int, c: Int): LinearForm {
        if (xs.size > 3) {
            for (i in xs.indices) {
                val depth = reference.valueAt(xs[i], ys[i], depths[a], depths[b], depths[c])
                if (!(depth > 1.0 && depth < Int.MAX_VALUE - 1.0)) return LinearForm.constant(depths[a])
            }
        }
        return reference.form(depths[a], depths[b], depths[c])
    }
}

/** Returns this primitive, or [EmptyPrimitive] if it is null. */
internal fun Primitive?.orEmpty(): Primitive = this ?: EmptyPrimitive
