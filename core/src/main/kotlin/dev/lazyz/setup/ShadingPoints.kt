package dev.lazyz.setup

import dev.lazyz.ChangedPrimitive
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.PrimitiveShading
import dev.lazyz.ShadingRate
import dev.lazyz.raster.EdgeForms
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans

/**
 * Where a primitive is shaded that has one colour in each pixel of [side] x [side] samples (contract rule 6.12): at the
 * mean of the pixel's samples that are in it, if it is a triangle, otherwise at the sample in it that is nearest to
 * their mean. It depends on nothing but the primitive, so that the order of evaluation does not matter. Immutable.
 *
 * A point is given as its distance from the first sample of its pixel, in grid units, see [right] and [down].
 *
 * @property side how many samples wide and high a pixel is, at least 2
 */
internal class ShadingPoints(val side: Int, private val rate: ShadingRate) : PrimitiveShading {
    /** Whether a primitive with the [shader] has one colour in each pixel, if it is a triangle. */
    fun isOnce(shader: Shader): Boolean =
        rate == ShadingRate.PIXEL || (rate == ShadingRate.AUTO && shader is MaterialShader && shader.isSmooth)

    override fun of(primitive: Primitive): Primitive {
        val shader = primitive.triangle()?.shader
        val isOnce = rate == ShadingRate.PIXEL || (shader != null && isOnce(shader))
        return if (isOnce) PixelShadedPrimitive(primitive, this) else primitive
    }

    /** Returns the first column of the pixel of column [x] or, with a row, the first row. */
    fun first(x: Int): Int = if (side and side - 1 == 0) x and -side else x - Math.floorMod(x, side)

    /**
     * Returns the point at which a triangle with these edge functions is shaded in the pixel whose first sample is
     * ([left], [top]). It covers some of the samples. A sample is in the triangle if no edge function is negative.
     */
    fun find(edges: EdgeForms, left: Int, top: Int): Int {
        var first0 = edges.at0(left, top)
        var first1 = edges.at1(left, top)
        var first2 = edges.at2(left, top)
        var count = 0
        var columns = 0
        var rows = 0
        for (row in 0 until side) {
            var v0 = first0
            var v1 = first1
            var v2 = first2
            val before = count
            for (column in 0 until side) {
                // Without a branch, which could not be predicted
                val inside = ((v0 or v1 or v2).inv() ushr Long.SIZE_BITS - 1).toInt()
                count += inside
                columns += inside * column
                v0 += edges.e0dx
                v1 += edges.e1dx
                v2 += edges.e2dx
            }
            rows += (count - before) * row
            first0 += edges.e0dy
            first1 += edges.e1dy
            first2 += edges.e2dy
        }
        return point(mean(columns, count), mean(rows, count))
    }

    /** As the other [find], for a primitive that has the samples of the pixel that are [inside], row by row. */
    fun find(inside: BooleanArray): Int {
        var count = 0
        var columns = 0
        var rows = 0
        for (sample in inside.indices) {
            if (!inside[sample]) continue
            count++
            columns += sample % side
            rows += sample / side
        }
        val column = mean(columns, count)
        val row = mean(rows, count)
        var nearest = 0
        var least = Int.MAX_VALUE
        for (sample in inside.indices) {
            val right = ScreenGrid.STEPS * (sample % side) - column
            val down = ScreenGrid.STEPS * (sample / side) - row
            if (!inside[sample] || right * right + down * down >= least) continue
            nearest = sample
            least = right * right + down * down
        }
        return point(ScreenGrid.STEPS * (nearest % side), ScreenGrid.STEPS * (nearest / side))
    }

    /** The mean of [count] columns or rows with this [sum], in grid units. */
    private fun mean(sum: Int, count: Int): Int = (ScreenGrid.STEPS * sum + count / 2) / count

    companion object {
        private const val ROW_SHIFT = 16

        /** Returns the point that is so far from the first sample of its pixel, in grid units. */
        fun point(right: Int, down: Int): Int = down shl ROW_SHIFT or right

        /** How far a point is right of the first sample of its pixel, in grid units. */
        fun right(point: Int): Int = point and (1 shl ROW_SHIFT) - 1

        /** How far a point is below the first sample of its pixel, in grid units. */
        fun down(point: Int): Int = point ushr ROW_SHIFT
    }
}

/** A primitive like [whole] that has one colour in each pixel, that of its shading point. */
internal class PixelShadedPrimitive(override val whole: Primitive, val points: ShadingPoints) :
    ChangedPrimitive,
    Primitive by whole {
    private val triangle = whole.triangle()

    override val heldBytes: Long get() = whole.heldBytes + HeapLayout.HEADER + 3 * HeapLayout.REFERENCE
    override val shadingStartCost: Int get() = 0

    override fun shade(fragment: Fragment) {
        val left = points.first(fragment.x)
        val top = points.first(fragment.y)
        val point = triangle?.shadingPoint(points, left, top) ?: points.find(covered(left, top))
        val right = ShadingPoints.right(point)
        val down = ShadingPoints.down(point)
        fragment.moveTo(left + right / ScreenGrid.STEPS, top + down / ScreenGrid.STEPS)
        fragment.footprintSide = points.side
        fragment.gridRight = right % ScreenGrid.STEPS
        fragment.gridDown = down % ScreenGrid.STEPS
        whole.shade(fragment)
        fragment.footprintSide = 1
        fragment.gridRight = 0
        fragment.gridDown = 0
    }

    /** Returns which samples of the pixel whose first sample is ([left], [top]) are covered, row by row. */
    private fun covered(left: Int, top: Int): BooleanArray {
        val side = points.side
        val covered = BooleanArray(side * side)
        for (row in maxOf(rowStart, top) until minOf(rowEnd, top + side)) {
            val spans = Spans(left, left + side)
            whole.spans(row, spans)
            for (i in 0 until spans.count) {
                covered.fill(true, (row - top) * side + spans.start(i) - left, (row - top) * side + spans.end(i) - left)
            }
        }
        return covered
    }

    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    override fun toString(): String = "PixelShadedPrimitive($whole)"
}

/** Returns the triangle that this primitive is, or that it changes; null if it is no triangle. */
private fun Primitive.triangle(): PlanarPrimitive? = when (this) {
    is PlanarPrimitive -> takeIf { isTriangle }
    is MaskedPrimitive -> null
    is ChangedPrimitive -> whole.triangle()
    else -> null
}
