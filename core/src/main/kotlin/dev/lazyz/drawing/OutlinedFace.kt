package dev.lazyz.drawing

import dev.lazyz.FillRule

/**
 * A flat face with contours: a polygon of the scene. Immutable.
 *
 * @property contours point numbers of each closed contour
 * @property isHiding whether it hides what is behind it
 */
internal class OutlinedFace(val contours: List<IntArray>, val fillRule: FillRule, val isHiding: Boolean) {
    private val points = contours.flatMap { it.asIterable() }.toHashSet()

    /** Whether [point] is a vertex. */
    fun has(point: Int): Boolean = point in points
}
