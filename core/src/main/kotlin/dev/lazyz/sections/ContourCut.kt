package dev.lazyz.sections

import dev.lazyz.FillRule
import dev.lazyz.Rgba
import dev.lazyz.world.surface.Vertex

/**
 * Cuts the contours of a polygon by a plane. First, each contour is cut by itself (Sutherland and Hodgman, "Reentrant
 * Polygon Clipping", CACM 17, 1974). If it is divided into several parts, sides in the plane connect them. Where such
 * sides cancel each other, they are removed, and the contours are joined anew, see [PlaneSides]. Otherwise they stay as
 * they are.
 */
internal object ContourCut {
    /** A vertex of a cut contour; [isInPlane] says whether it is in the plane. */
    class Corner(val vertex: Vertex, val isInPlane: Boolean)

    /** Returns the kept part of the polygon with these [contours]. */
    fun of(contours: List<List<Vertex>>, fillRule: FillRule, plane: SectionPlane): List<List<Vertex>> {
        val cut = contours.map { of(it, plane) }
        val sides = PlaneSides(cut, fillRule)
        return if (sides.hasCancelled) sides.contours() else cut.map { contour -> contour.map { it.vertex } }
    }

    private fun of(contour: List<Vertex>, plane: SectionPlane): List<Corner> {
        val kept = ArrayList<Corner>(contour.size + 2)
        for (i in contour.indices) {
            val a = contour[i]
            val b = contour[(i + 1) % contour.size]
            val heightA = plane.height(a.x, a.y, a.z)
            val heightB = plane.height(b.x, b.y, b.z)
            if (heightA <= 0.0) kept += Corner(a, heightA == 0.0)
            if (heightA < 0.0 && heightB > 0.0) kept += Corner(between(a, b, heightA / (heightA - heightB)), true)
            if (heightA > 0.0 && heightB < 0.0) kept += Corner(between(b, a, heightB / (heightB - heightA)), true)
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
