package dev.lazyz.raster

import dev.lazyz.LinearForm

/**
 * Three snapped vertices that define the linear forms of a primitive (contract rule 3).
 *
 * Coordinates are on the 1/256 pixel grid, within the guard band, so all products below are exact in 64 bits.
 */
internal class ReferenceTriangle(val x0: Int, val y0: Int, val x1: Int, val y1: Int, val x2: Int, val y2: Int) {
    private val dx1: Long get() = (x1 - x0).toLong()
    private val dy1: Long get() = (y1 - y0).toLong()
    private val dx2: Long get() = (x2 - x0).toLong()
    private val dy2: Long get() = (y2 - y0).toLong()

    /** Twice the signed area, square grid units; positive if the vertices are in clockwise order on the screen. */
    private val area: Long get() = dx1 * dy2 - dx2 * dy1

    /** Twice the area, square grid units. */
    val size: Long get() = Math.abs(area)

    /**
     * Returns the edge function opposite to vertex [corner], 0..2. At each sample it is twice the area, in square grid
     * units, of the triangle of the sample and the other two vertices; positive on the side of [corner]. It is an exact
     * integer, without a fraction. At every sample the three edge functions add up to [size].
     */
    fun edgeFunction(corner: Int): LinearForm = when (corner) {
        0 -> edgeFunction(x1, y1, x2, y2)
        1 -> edgeFunction(x2, y2, x0, y0)
        else -> edgeFunction(x0, y0, x1, y1)
    }

    private fun edgeFunction(fromX: Int, fromY: Int, toX: Int, toY: Int): LinearForm {
        val sign = if (area < 0) -1L else 1L
        val runX = sign * (toX - fromX)
        val runY = sign * (toY - fromY)
        val down = (ScreenGrid.CENTER - fromY).toLong()
        val right = (ScreenGrid.CENTER - fromX).toLong()
        return LinearForm(runX * down - runY * right, -ScreenGrid.STEPS * runY, ScreenGrid.STEPS * runX)
    }

    /**
     * Returns the form that has the values [v0], [v1], [v2] at the three vertices, to within [ERROR_BOUND] units.
     *
     * A form that changes by [STEEP] or more from one sample to the next cannot be represented; the result is then [v0]
     * everywhere (rule 3.4). The same holds for a triangle without area.
     */
    fun form(v0: Int, v1: Int, v2: Int): LinearForm = formUnlessSteep(v0, v1, v2) ?: LinearForm.constant(v0)

    /** As [form], but returns null if the form is too steep or the triangle has no area. */
    fun formUnlessSteep(v0: Int, v1: Int, v2: Int): LinearForm? {
        val dv1 = v1.toLong() - v0
        val dv2 = v2.toLong() - v0

        // Solve for the plane exactly, round each slope once
        val slopeX = slope(dv1 * dy2 - dv2 * dy1, area)
        val slopeY = slope(dv2 * dx1 - dv1 * dx2, area)
        if (isSteep(slopeX, slopeY)) return null
        return LinearForm(origin(v0, x0, y0, slopeX, slopeY), rounded(slopeX), rounded(slopeY))
    }

    /** Returns the value of the plane at the grid point ([x], [y]); NaN or infinite if there is no plane. */
    fun valueAt(x: Int, y: Int, v0: Int, v1: Int, v2: Int): Double {
        val dv1 = v1.toLong() - v0
        val dv2 = v2.toLong() - v0
        val slopeX = (dv1 * dy2 - dv2 * dy1).toDouble() / area.toDouble()
        val slopeY = (dv2 * dx1 - dv1 * dx2).toDouble() / area.toDouble()
        return v0 + slopeX * (x - x0).toDouble() + slopeY * (y - y0).toDouble()
    }

    companion object {
        /** Returns a slope of a form in fraction units a pixel: [numerator] / [area], both exact. */
        fun slope(numerator: Long, area: Long): Double = numerator.toDouble() / area.toDouble() * PER_PIXEL

        /** Whether the slopes are too steep for a form, or NaN. */
        fun isSteep(slopeX: Double, slopeY: Double): Boolean = !(Math.abs(slopeX) < STEEP && Math.abs(slopeY) < STEEP)

        /** Returns the step of a form with this slope. */
        fun rounded(slope: Double): Long = Math.rint(slope).toLong()

        /**
         * Returns the value at sample (0, 0) of the form that has these slopes and the integer part [v0] at ([x0],
         * [y0]).
         */
        fun origin(v0: Int, x0: Int, y0: Int, slopeX: Double, slopeY: Double): Long {
            // Anchor at the pixel of the vertex, then move the origin to sample (0, 0)
            val column = x0 shr ScreenGrid.SHIFT
            val row = y0 shr ScreenGrid.SHIFT
            val offsetX = (column * ScreenGrid.STEPS + ScreenGrid.CENTER - x0) / ScreenGrid.STEPS.toDouble()
            val offsetY = (row * ScreenGrid.STEPS + ScreenGrid.CENTER - y0) / ScreenGrid.STEPS.toDouble()
            val anchor = (v0.toLong() shl 32) + LinearForm.HALF + rounded(slopeX * offsetX + slopeY * offsetY)
            return anchor - rounded(slopeX) * column - rounded(slopeY) * row
        }

        /** Conversion from a slope in units a grid step to fraction units a pixel: 256 steps a pixel times 2^32. */
        private const val PER_PIXEL = 256.0 * 4294967296.0

        /** The smallest slope that is too steep: 2^61, a quarter of the range of depths from one sample to the next. */
        const val STEEP: Double = 2305843009213693952.0

        /**
         * Maximum difference, in units, between the integer part of a form and exact rational arithmetic, at any sample
         * of the raster.
         *
         * Half a unit is due to rounding to an integer. Each slope has an error of at most 3 x 2^-53 of itself (two
         * conversions and one division) and of half a fraction unit, over at most 3/4 x 2^20 pixels; for two slopes
         * below 2^61 this is 0.29.
         */
        const val ERROR_BOUND: Double = 0.8
    }
}

/** The edge functions of a reference triangle, see [ReferenceTriangle.edgeFunction]. Immutable. */
internal class EdgeFunctions(reference: ReferenceTriangle) {
    val first: LinearForm = reference.edgeFunction(0)
    val second: LinearForm = reference.edgeFunction(1)
    val third: LinearForm = reference.edgeFunction(2)
}
