package dev.lazyz.setup

import dev.lazyz.shading.Vertices

/**
 * Cuts polygons at the near plane, the far plane and the guard band, in homogeneous space (contract rule 9).
 *
 * Source: Ivan Sutherland and Gary Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17 (1974), contour by
 * contour. Two refinements. A cut is computed in one way whichever way the contour goes, so that both polygons at an edge
 * get the same point. And where a contour runs along the plane, from where it left to where it
 * came back, it visits every other cut in between: runs that overlap then share their ends, and cancel exactly after
 * snapping.
 *
 * @param guardX the guard band: what is inside has -guardX w <= x <= guardX w
 * @param guardY see [guardX]
 * @param near the near plane: what is inside has near w <= z <= w
 */
internal class Clipper(private val guardX: Double, private val guardY: Double, private val near: Double) {
    /** Returns a bit for each plane that [vertex] is outside of. */
    fun outcode(vertices: Vertices, vertex: Int): Int {
        var code = 0
        for (plane in 0 until PLANES) if (distance(vertices, vertex, plane) < 0.0) code = code or (1 shl plane)
        return code
    }

    /** Whether a position in clip space is inside all planes, and somewhere: finite, and before the eye. */
    fun isInside(x: Double, y: Double, z: Double, w: Double): Boolean =
        w > 0.0 && w < Double.POSITIVE_INFINITY && z - near * w >= 0.0 && w - z >= 0.0 &&
            guardX * w + x >= 0.0 && guardX * w - x >= 0.0 && guardY * w + y >= 0.0 && guardY * w - y >= 0.0

    /**
     * Cuts the contours at the planes in [planes] (bits as in [outcode]); new vertices are appended to [vertices].
     *
     * @return what is left of the contours, without empty ones
     */
    fun clip(vertices: Vertices, contours: List<IntArray>, planes: Int): List<IntArray> {
        var left = contours
        for (plane in 0 until PLANES) if (planes and (1 shl plane) != 0) left = clipAt(vertices, left, plane)
        return left
    }

    /**
     * Cuts the segment between two vertices at all planes; new vertices are appended to [vertices].
     *
     * @return the ends of what is left, in the segment's direction, or null if that is nothing
     */
    fun clipSegment(vertices: Vertices, from: Int, to: Int): Pair<Int, Int>? {
        var first = from
        var second = to
        for (plane in 0 until PLANES) {
            val firstDistance = distance(vertices, first, plane)
            val secondDistance = distance(vertices, second, plane)
            if (firstDistance < 0.0 && secondDistance < 0.0) return null
            if (firstDistance < 0.0) first = vertices.addCut(second, first, secondDistance, firstDistance)
            if (secondDistance < 0.0) second = vertices.addCut(first, second, firstDistance, secondDistance)
        }
        return Pair(first, second)
    }

    private fun clipAt(vertices: Vertices, contours: List<IntArray>, plane: Int): List<IntArray> {
        val firstCut = vertices.count
        val clipped = contours.map { clipContour(vertices, it, plane) }.filter { it.isNotEmpty() }
        val cuts = vertices.count - firstCut
        return if (cuts <= 2) clipped else clipped.map { withBridgesSplit(vertices, it, firstCut) }
    }

    private fun clipContour(vertices: Vertices, contour: IntArray, plane: Int): IntArray {
        val result = IntArray(2 * contour.size)
        var size = 0
        var previous = contour[contour.size - 1]
        var previousDistance = distance(vertices, previous, plane)
        for (current in contour) {
            val currentDistance = distance(vertices, current, plane)
            if ((previousDistance < 0.0) != (currentDistance < 0.0)) {
                result[size++] = if (previousDistance >= 0.0) {
                    vertices.addCut(previous, current, previousDistance, currentDistance)
                } else {
                    vertices.addCut(current, previous, currentDistance, previousDistance)
                }
            }
            if (currentDistance >= 0.0) result[size++] = current
            previous = current
            previousDistance = currentDistance
        }
        return result.copyOf(size)
    }

    /** Inserts into each run along the plane the other cuts that lie on it. Cuts are the vertices from [firstCut] on. */
    private fun withBridgesSplit(vertices: Vertices, contour: IntArray, firstCut: Int): IntArray {
        val result = ArrayList<Int>()
        for (i in contour.indices) {
            val from = contour[i]
            val to = contour[(i + 1) % contour.size]
            result.add(from)
            if (from < firstCut || to < firstCut) continue
            val length = along(vertices, from, to, to)
            (firstCut until vertices.count)
                .filter {
                    it != from && it != to && along(vertices, from, to, it) > 0.0 &&
                        along(vertices, from, to, it) < length
                }
                .sortedBy { along(vertices, from, to, it) }
                .forEach { result.add(it) }
        }
        return result.toIntArray()
    }

    /** How far along the run from [from] to [to] the cut [cut] is, on the screen, to scale. */
    private fun along(vertices: Vertices, from: Int, to: Int, cut: Int): Double {
        val fromX = vertices.get(from, Vertices.X) / vertices.get(from, Vertices.W)
        val fromY = vertices.get(from, Vertices.Y) / vertices.get(from, Vertices.W)
        val runX = vertices.get(to, Vertices.X) / vertices.get(to, Vertices.W) - fromX
        val runY = vertices.get(to, Vertices.Y) / vertices.get(to, Vertices.W) - fromY
        val cutX = vertices.get(cut, Vertices.X) / vertices.get(cut, Vertices.W) - fromX
        val cutY = vertices.get(cut, Vertices.Y) / vertices.get(cut, Vertices.W) - fromY
        return runX * cutX + runY * cutY
    }

    /** Distance of [vertex] from a plane, to scale; negative outside. Linear in the position. */
    private fun distance(vertices: Vertices, vertex: Int, plane: Int): Double {
        val w = vertices.get(vertex, Vertices.W)
        return when (plane) {
            NEAR -> vertices.get(vertex, Vertices.Z) - near * w
            FAR -> w - vertices.get(vertex, Vertices.Z)
            LEFT -> guardX * w + vertices.get(vertex, Vertices.X)
            RIGHT -> guardX * w - vertices.get(vertex, Vertices.X)
            BOTTOM -> guardY * w + vertices.get(vertex, Vertices.Y)
            else -> guardY * w - vertices.get(vertex, Vertices.Y)
        }
    }

    private companion object {
        const val NEAR = 0
        const val FAR = 1
        const val LEFT = 2
        const val RIGHT = 3
        const val BOTTOM = 4
        const val PLANES = 6
    }
}
