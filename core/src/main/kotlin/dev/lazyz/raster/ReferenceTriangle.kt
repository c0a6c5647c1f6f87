package dev.lazyz.raster

import dev.lazyz.spi.LinearForm

/**
 * Three snapped vertices that define the linear forms of a primitive (contract rule 3).
 *
 * Coordinates are on the 1/256 pixel grid, within the guard band, so all products below are exact in 64 bits.
 */
internal class ReferenceTriangle(val x0: Int, val y0: Int, val x1: Int, val y1: Int, val x2: Int, val y2: Int) {
    /** Twice the signed area, square grid units; positive if the vertices are in clockwise order on the screen. */
    private val area: Long get() = Edge.function(x0, y0, x1, y1, x2, y2)

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
        val origin = sign * Edge.function(fromX, fromY, toX, toY, ScreenGrid.CENTER, ScreenGrid.CENTER)
        val steps = sign * ScreenGrid.STEPS
        return LinearForm(origin, -steps * (toY - fromY), steps * (toX - fromX))
    }

    /**
     * Returns the form that has the values [v0], [v1], [v2] at the three vertices, to within [ERROR_BOUND] units.
     *
     * A form that changes by [STEEP] or more from one sample to the next cannot be represented; the result is then [v0]
     * everywhere (rule 3.4). The same holds for a triangle without area.
     */
    fun form(v0: Int, v1: Int, v2: Int): LinearForm = formUnlessSteep(v0, v1, v2) ?: LinearForm.constant(v0)

    /** As [form], but returns null if the form is too steep or the triangle has no area. */
    fun formUnlessSteep(v0: Int, v1: Int, v2: Int): LinearForm? =
        form(x0, y0, v0, x1, y1, v1, x2, y2, v2, steep = { null }) { origin, dx, dy -> LinearForm(origin, dx, dy) }

    /** Returns the value of the plane at the grid point ([x], [y]); NaN or infinite if there is no plane. */
    fun valueAt(x: Int, y: Int, v0: Int, v1: Int, v2: Int): Double =
        slopes(x0, y0, v0, x1, y1, v1, x2, y2, v2) { slopeX, slopeY ->
            v0 + slopeX * (x - x0).toDouble() + slopeY * (y - y0).toDouble()
        }

    companion object {
        /**
         * Passes the form that has the values [v0], [v1], [v2] at three vertices to [use]: its value at sample (0, 0)
         * and its steps. If it is too steep, or the triangle has no area, calls [steep] instead.
         */
        inline fun <R> form(
            x0: Int,
            y0: Int,
            v0: Int,
            x1: Int,
            y1: Int,
            v1: Int,
            x2: Int,
            y2: Int,
            v2: Int,
            steep: () -> R,
            use: (origin: Long, dx: Long, dy: Long) -> R,
        ): R = slopes(x0, y0, v0, x1, y1, v1, x2, y2, v2) { gridX, gridY ->
            val slopeX = gridX * PER_PIXEL
            val slopeY = gridY * PER_PIXEL
            val isGentle = Math.abs(slopeX) < STEEP && Math.abs(slopeY) < STEEP
            if (isGentle) use(origin(v0, x0, y0, slopeX, slopeY), rounded(slopeX), rounded(slopeY)) else steep()
        }

        /**
         * Passes the slopes of the plane through three vertices to [use], in units a grid step. Each is an exact
         * numerator, divided once by the exact area; NaN or infinite without area.
         */
        inline fun <R> slopes(
            x0: Int,
            y0: Int,
            v0: Int,
            x1: Int,
            y1: Int,
            v1: Int,
            x2: Int,
            y2: Int,
            v2: Int,
            use: (slopeX: Double, slopeY: Double) -> R,
        ): R {
            val dx1 = (x1 - x0).toLong()
            val dy1 = (y1 - y0).toLong()
            val dx2 = (x2 - x0).toLong()
            val dy2 = (y2 - y0).toLong()
            val dv1 = v1.toLong() - v0
            val dv2 = v2.toLong() - v0
            val area = Edge.function(x0, y0, x1, y1, x2, y2).toDouble()
            return use((dv1 * dy2 - dv2 * dy1).toDouble() / area, (dv2 * dx1 - dv1 * dx2).toDouble() / area)
        }

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
        const val PER_PIXEL: Double = 256.0 * 4294967296.0

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

/**
 * The three edge functions of a triangle, as linear forms: values at an origin sample, and steps by column and row.
 *
 * These are fields, not properties, because the innermost loops read them.
 */
internal open class EdgeForms {
    @JvmField var e0: Long = 0L

    @JvmField var e1: Long = 0L

    @JvmField var e2: Long = 0L

    @JvmField var e0dx: Long = 0L

    @JvmField var e1dx: Long = 0L

    @JvmField var e2dx: Long = 0L

    @JvmField var e0dy: Long = 0L

    @JvmField var e1dy: Long = 0L

    @JvmField var e2dy: Long = 0L

    /**
     * Sets the functions of the edges opposite each vertex, not negative in the triangle and on its border. The origin
     * is sample (0, 0) of the raster.
     */
    fun opposite(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int) {
        val sign = if (Edge.function(ax, ay, bx, by, cx, cy) < 0) -1L else 1L
        val steps = sign * ScreenGrid.STEPS
        e0dx = -steps * (cy - by)
        e0dy = steps * (cx - bx)
        e0 = sign * edge(bx, by, cx, cy)
        e1dx = -steps * (ay - cy)
        e1dy = steps * (ax - cx)
        e1 = sign * edge(cx, cy, ax, ay)
        e2dx = -steps * (by - ay)
        e2dy = steps * (bx - ax)
        e2 = sign * edge(ax, ay, bx, by)
    }

    private fun edge(fromX: Int, fromY: Int, toX: Int, toY: Int): Long =
        Edge.function(fromX, fromY, toX, toY, ScreenGrid.CENTER, ScreenGrid.CENTER)

    /** Returns the first function at a sample. */
    fun at0(x: Int, y: Int): Long = e0 + e0dx * x + e0dy * y

    /** As [at0], for the second function. */
    fun at1(x: Int, y: Int): Long = e1 + e1dx * x + e1dy * y

    /** As [at0], for the third function. */
    fun at2(x: Int, y: Int): Long = e2 + e2dx * x + e2dy * y

    /**
     * Returns the first function at a point that is [x] grid units right of sample (0, 0), and [y] below it. It is
     * exact, because a step from sample to sample is a multiple of [ScreenGrid.STEPS].
     */
    fun atGrid0(x: Int, y: Int): Long = e0 + (e0dx shr ScreenGrid.SHIFT) * x + (e0dy shr ScreenGrid.SHIFT) * y

    /** As [atGrid0], for the second function. */
    fun atGrid1(x: Int, y: Int): Long = e1 + (e1dx shr ScreenGrid.SHIFT) * x + (e1dy shr ScreenGrid.SHIFT) * y

    /** As [atGrid0], for the third function. */
    fun atGrid2(x: Int, y: Int): Long = e2 + (e2dx shr ScreenGrid.SHIFT) * x + (e2dy shr ScreenGrid.SHIFT) * y
}
