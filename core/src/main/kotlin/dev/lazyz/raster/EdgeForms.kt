package dev.lazyz.raster

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
