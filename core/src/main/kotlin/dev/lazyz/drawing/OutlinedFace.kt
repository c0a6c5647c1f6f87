package dev.lazyz.drawing

import dev.lazyz.FillRule

/**
 * A flat face with contours: a polygon of the scene. Immutable.
 *
 * @property contours point numbers of each closed contour
 */
internal class OutlinedFace(val contours: List<IntArray>, val fillRule: FillRule) {
    /** All vertices, in the order of the contours. */
    val points: Set<Int> = contours.flatMapTo(LinkedHashSet()) { it.asIterable() }

    /** Whether [point] is a vertex. */
    fun has(point: Int): Boolean = point in points
}
