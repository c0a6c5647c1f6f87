package dev.lazyz.conformance.oracle

/**
 * Coverage of polygons on a small lattice, in integers: fast enough for millions of polygons.
 *
 * Shares nothing with set-up or [ExactPolygon]. Triangles are decided by the signs of their three edge functions and
 * the top-left rule as in rasterizer manuals; other polygons by their winding numbers, from rules 2.1 to 2.4. Bit
 * `y * width + x` of a mask is set if that sample is covered.
 *
 * @param from the lattice's least coordinate on either axis, in grid steps
 * @param step distance of adjacent lattice points, in grid steps
 * @param side number of lattice points in a row
 */
internal class SmallLattice(private val from: Int, private val step: Int, private val side: Int, val raster: Int) {
    /** Number of lattice points. */
    val points: Int get() = side * side

    fun x(point: Int): Int = from + point % side * step

    fun y(point: Int): Int = from + point / side * step

    /** Twice the signed area; positive if a, b, c are clockwise on the screen, where y grows downward. */
    fun area(a: Int, b: Int, c: Int): Int = edge(a, b, x(c), y(c))

    private fun edge(a: Int, b: Int, x: Int, y: Int): Int = (x(b) - x(a)) * (y - y(a)) - (y(b) - y(a)) * (x - x(a))

    /** The samples that a triangle covers. */
    fun triangle(a: Int, b: Int, c: Int): Int {
        val area = area(a, b, c)
        return when {
            area == 0 -> 0
            area < 0 -> clockwise(a, c, b)
            else -> clockwise(a, b, c)
        }
    }

    private fun clockwise(a: Int, b: Int, c: Int): Int = mask { x, y ->
        isInside(a, b, x, y) && isInside(b, c, x, y) && isInside(c, a, x, y)
    }

    /** On the inner side of a clockwise edge, or on it, if it is a left edge (upward) or a top one (to the right). */
    private fun isInside(a: Int, b: Int, x: Int, y: Int): Boolean {
        val distance = edge(a, b, x, y)
        return distance > 0 || (distance == 0 && (y(b) < y(a) || (y(b) == y(a) && x(b) > x(a))))
    }

    /** The samples at which the winding number of the contour through [vertices] passes [test]. */
    fun windings(vertices: IntArray, test: (Int) -> Boolean): Int = mask { x, y ->
        var sum = 0
        for (i in vertices.indices) sum += crossing(vertices[i], vertices[(i + 1) % vertices.size], x, y)
        test(sum)
    }

    private fun crossing(a: Int, b: Int, x: Int, y: Int): Int {
        if (y(a) <= y && y < y(b)) return if (edge(a, b, x, y) <= 0) 1 else 0
        if (y(b) <= y && y < y(a)) return if (edge(b, a, x, y) <= 0) -1 else 0
        return 0
    }

    private inline fun mask(test: (Int, Int) -> Boolean): Int {
        var bits = 0
        for (i in 0 until raster * raster) {
            if (test(256 * (i % raster) + 128, 256 * (i / raster) + 128)) bits = bits or (1 shl i)
        }
        return bits
    }
}
