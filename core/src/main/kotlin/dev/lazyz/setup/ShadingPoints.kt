package dev.lazyz.setup

import dev.lazyz.HeapLayout
import dev.lazyz.ObservedPrimitive
import dev.lazyz.OpaquePrimitive
import dev.lazyz.Primitive
import dev.lazyz.PrimitiveShading
import dev.lazyz.ShadingRate
import dev.lazyz.raster.EdgeForms
import dev.lazyz.shading.MaterialShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans

/**
 * Where a primitive is shaded that has one colour in each pixel of [side] x [side] samples (contract rule 6.13): at the
 * pixel's centre if that is in the primitive, otherwise at the first sample in it, from the centre outward. It depends
 * on nothing but the primitive, so that the order of evaluation does not matter. Immutable.
 *
 * @property side how many samples wide and high a pixel is, at least 2
 */
internal class ShadingPoints(val side: Int, private val rate: ShadingRate) : PrimitiveShading {
    /** The samples of a pixel from its centre outward: their columns and rows in the pixel. */
    private val columns: IntArray
    private val rows: IntArray

    /** The number of each sample in that order, by row and column. */
    private val numbers = IntArray(side * side)

    /** How many half samples the centre is right of sample number 0, and below it. */
    private val half: Int = 1 - side % 2

    init {
        fun square(position: Int): Int = (2 * position + 1 - side) * (2 * position + 1 - side)
        val order = (0 until side * side).sortedBy { square(it / side) + square(it % side) }
        columns = IntArray(order.size) { order[it] % side }
        rows = IntArray(order.size) { order[it] / side }
        for (number in order.indices) numbers[order[number]] = number
    }

    /** Returns the column of sample [number] in the pixel of column [x]; for [CENTRE], that of the sample before it. */
    fun column(number: Int, x: Int): Int = x - Math.floorMod(x, side) + columns[maxOf(number, 0)]

    /** As [column], for the row [y]. */
    fun row(number: Int, y: Int): Int = y - Math.floorMod(y, side) + rows[maxOf(number, 0)]

    /** How many half samples a point is right of that column and below that row, see [Fragment.halfSteps]. */
    fun half(number: Int): Int = if (number == CENTRE) half else 0

    /** Returns the number of the sample at column [x] and row [y] of the raster. */
    fun number(x: Int, y: Int): Int = numbers[Math.floorMod(y, side) * side + Math.floorMod(x, side)]

    /** Whether a primitive with the [shader] has one colour in each pixel, if it is a triangle. */
    fun isOnce(shader: Shader): Boolean =
        rate == ShadingRate.PIXEL || rate == ShadingRate.AUTO && shader is MaterialShader && shader.isSmooth

    override fun of(primitive: Primitive): Primitive {
        val shader = primitive.triangle()?.shader
        val isOnce = rate == ShadingRate.PIXEL || shader != null && isOnce(shader)
        return if (isOnce) PixelShadedPrimitive(primitive, this) else primitive
    }

    /**
     * Returns the number of the sample at which a triangle with these edge functions is shaded in the pixel of sample
     * ([x], [y]), which it covers; or [CENTRE].
     */
    fun find(forms: EdgeForms, x: Int, y: Int): Int = find(x, y) { column, row, half ->
        forms.at0(column, row, half) or forms.at1(column, row, half) or forms.at2(column, row, half) >= 0
    }

    /** As the other [find], for any primitive: [isInside] tells whether a sample, or half a sample further, is in it. */
    inline fun find(x: Int, y: Int, isInside: (column: Int, row: Int, half: Int) -> Boolean): Int {
        if (isInside(column(CENTRE, x), row(CENTRE, y), half(CENTRE))) return CENTRE
        val known = number(x, y)
        for (number in 0 until known) if (isInside(column(number, x), row(number, y), 0)) return number
        return known
    }

    companion object {
        /** Instead of the number of a sample: the centre of the pixel. */
        const val CENTRE: Int = -1
    }
}

/** A primitive like [whole] that has one colour in each pixel, that of its shading point. */
internal class PixelShadedPrimitive(val whole: Primitive, private val points: ShadingPoints) : Primitive by whole {
    private val triangle = whole.triangle()

    override val heldBytes: Long get() = whole.heldBytes + HeapLayout.HEADER + 3 * HeapLayout.REFERENCE
    override val shadingStartCost: Int get() = 0

    override fun shade(fragment: Fragment) {
        val x = fragment.x
        val y = fragment.y
        val number = if (triangle != null) triangle.shadingPoint(points, x, y) else firstSample(x, y)
        fragment.moveTo(points.column(number, x), points.row(number, y))
        fragment.footprintSide = points.side
        fragment.halfSteps = points.half(number)
        whole.shade(fragment)
        fragment.footprintSide = 1
        fragment.halfSteps = 0
    }

    /** Only the samples that a primitive covers are known to be in it. */
    private fun firstSample(x: Int, y: Int): Int {
        val spans = Spans()
        return points.find(x, y) { column, row, half ->
            spans.clear()
            if (row in rowStart until rowEnd) whole.spans(row, spans)
            half == 0 && (0 until spans.count).any { column >= spans.start(it) && column < spans.end(it) }
        }
    }

    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    override fun toString(): String = "PixelShadedPrimitive($whole)"
}

/** Returns the triangle that this primitive is, or that it changes; null if it is no triangle. */
private fun Primitive.triangle(): PlanarPrimitive? = when (this) {
    is PlanarPrimitive -> takeIf { isTriangle }
    is OpaquePrimitive -> whole.triangle()
    is ObservedPrimitive -> whole.triangle()
    else -> null
}
