package dev.lazyz.sections

import dev.lazyz.Rgba
import dev.lazyz.world.surface.Vertex

/**
 * Cuts one contour of a polygon by a plane (Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17, 1974). A
 * contour that is divided into several parts stays one contour, with sides in the plane that cancel each other.
 */
internal object ContourCut {
    /** Returns the kept part of [contour]. */
    fun of(contour: List<Vertex>, plane: SectionPlane): List<Vertex> {
        val kept = ArrayList<Vertex>(contour.size + 2)
        for (i in contour.indices) {
            val a = contour[i]
            val b = contour[(i + 1) % contour.size]
            val heightA = plane.height(a.x, a.y, a.z)
            val heightB = plane.height(b.x, b.y, b.z)
            if (heightA <= 0.0) kept += a
            if (heightA < 0.0 && heightB > 0.0) kept += between(a, b, heightA / (heightA - heightB))
            if (heightA > 0.0 && heightB < 0.0) kept += between(b, a, heightB / (heightB - heightA))
        }
        return kept
    }

    private fun between(a: Vertex, b: Vertex, t: Double): Vertex {
        fun mix(from: Float, to: Float) = (from + t * (to.toDouble() - from)).toFloat()
        val color = Rgba(
            mix(a.color.red, b.color.red), mix(a.color.green, b.color.green), mix(a.color.blue, b.color.blue),
            mix(a.color.alpha, b.color.alpha),
        )
        return Vertex(
            a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), mix(a.u, b.u), mix(a.v, b.v), color,
        )
    }
}
