package dev.lazyz.strategies.bsp

import dev.lazyz.setup.VertexStage

/**
 * Planes of the world as linear functions of column, row and depth: on the grid of the screen, where straight planes
 * stay straight. Immutable.
 *
 * Any linear function may divide snapped vertices, so these need not be exact: [ListPriority] looks at the vertices.
 */
internal class ScreenPlanes(stage: VertexStage) {
    /** For each coordinate of the world and 1, the coefficients of column, row, depth and 1. */
    private val rows = DoubleArray(16)

    init {
        // The inverse of the matrix to clip space, but for a positive factor
        val m = stage.worldToClip
        val clip = doubleArrayOf(
            m.m00, m.m10, m.m20, m.m30, m.m01, m.m11, m.m21, m.m31,
            m.m02, m.m12, m.m22, m.m32, m.m03, m.m13, m.m23, m.m33,
        )
        var determinant = 0.0
        for (row in 0 until 4) determinant += clip[4 * row] * cofactor(clip, row, 0)
        val sign = if (determinant < 0.0) -1.0 else 1.0

        // The grid is linear in x/w, y/w and z/w, and exact at these places
        val viewport = stage.viewport
        val x0 = viewport.gridX(0.0, 1.0).toDouble()
        val y0 = viewport.gridY(0.0, 1.0).toDouble()
        val z0 = viewport.depth(viewport.near, 1.0).toDouble()
        val x1 = viewport.gridX(1.0, 1.0) - x0
        val y1 = viewport.gridY(1.0, 1.0) - y0
        val z1 = (viewport.depth(1.0, 1.0) - z0) / (1.0 - viewport.near)
        for (column in 0 until 4) {
            val x = sign * cofactor(clip, 0, column) / x1
            val y = sign * cofactor(clip, 1, column) / y1
            val z = sign * cofactor(clip, 2, column) / z1
            rows[4 * column] = x
            rows[4 * column + 1] = y
            rows[4 * column + 2] = z
            rows[4 * column + 3] = sign * cofactor(clip, 3, column) - x * x0 - y * y0 - z * (z0 - viewport.near * z1)
        }
    }

    /** Returns the determinant of [m], by rows, without a row and a column, with the sign of its place. */
    private fun cofactor(m: DoubleArray, row: Int, column: Int): Double {
        val r = IntArray(3) { if (it < row) it else it + 1 }
        val c = IntArray(3) { if (it < column) it else it + 1 }
        var sum = 0.0
        for (i in 0 until 3) {
            val j = (i + 1) % 3
            val k = (i + 2) % 3
            sum += m[4 * r[0] + c[i]] *
                (m[4 * r[1] + c[j]] * m[4 * r[2] + c[k]] - m[4 * r[1] + c[k]] * m[4 * r[2] + c[j]])
        }
        return if ((row + column) % 2 == 0) sum else -sum
    }

    /**
     * Writes the function that is negative where the plane of [node] is, and positive where it is, to four elements of
     * [to] from [at] on.
     */
    fun write(tree: PlaneTree, node: Int, to: DoubleArray, at: Int) {
        for (k in 0 until 4) {
            to[at + k] = tree.plane(node, 0) * rows[k] + tree.plane(node, 1) * rows[4 + k] +
                tree.plane(node, 2) * rows[8 + k] + tree.plane(node, 3) * rows[12 + k]
        }
    }
}
