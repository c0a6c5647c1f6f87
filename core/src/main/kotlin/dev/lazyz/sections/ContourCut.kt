package dev.lazyz.sections

import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.sections.Section
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import org.joml.Vector3dc

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
    fun of(contours: List<List<Vertex>>, fillRule: FillRule, plane: Section.Plane): List<List<Vertex>> {
        val cut = contours.map { of(it, plane) }
        val sides = PlaneSides(cut, fillRule)
        return if (sides.hasCancelled) sides.contours() else cut.map { contour -> contour.map { it.vertex } }
    }

    private fun of(contour: List<Vertex>, plane: Section.Plane): List<Corner> {
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

/**
 * The sides of cut contours that lie in the plane of the cut. As the polygon is flat, they are on one line. They are
 * divided at all corners on that line; between two corners, opposite sides cancel each other. With [FillRule.EVEN_ODD],
 * directions do not matter, and any two sides cancel each other. Used once; not thread safe.
 *
 * Cost: linear in the number of corners, apart from sorting those in the plane.
 */
internal class PlaneSides(private val cut: List<List<ContourCut.Corner>>, private val fillRule: FillRule) {
    private data class Place(val x: Double, val y: Double, val z: Double)

    /** A part of a contour from one place on the line to another one, given by their numbers. */
    private class Part(val from: Int, val until: Int, val vertices: List<Vertex>) {
        var isUsed = false
    }

    /** One vertex at each place, in order along the line. */
    private val nodes: List<Vertex>
    private val numbers = HashMap<Place, Int>()

    /** By node: how many sides lead from it to the next one, and back. */
    private val forward: IntArray
    private val backward: IntArray

    /** Whether sides cancel each other. */
    val hasCancelled: Boolean get() = nodes.indices.any {
        if (fillRule == FillRule.EVEN_ODD) forward[it] + backward[it] > 1 else forward[it] > 0 && backward[it] > 0
    }

    init {
        // Sort the places by their distance from one of them in the direction of the farthest other one
        val all = cut.flatten().filter { it.isInPlane }.map { it.vertex }.distinctBy(::place)
        val first = all.firstOrNull()
        val last = all.maxByOrNull { along(first!!, it, it) }
        nodes = all.sortedBy { along(first!!, last!!, it) }
        nodes.forEachIndexed { i, vertex -> numbers[place(vertex)] = i }

        // Count where sides begin and end, and add up
        forward = IntArray(nodes.size)
        backward = IntArray(nodes.size)
        for (contour in cut) {
            for (i in contour.indices) {
                val a = contour[i]
                val b = contour[(i + 1) % contour.size]
                if (!a.isInPlane || !b.isInPlane) continue
                val from = number(a.vertex)
                val until = number(b.vertex)
                val counts = if (from < until) forward else backward
                counts[minOf(from, until)]++
                counts[maxOf(from, until)]--
            }
        }
        for (i in 1 until nodes.size) {
            forward[i] += forward[i - 1]
            backward[i] += backward[i - 1]
        }
    }

    /** The position of a vertex; adding 0 makes -0 equal to 0. */
    private fun place(vertex: Vertex) = Place(vertex.x + 0.0, vertex.y + 0.0, vertex.z + 0.0)

    private fun number(vertex: Vertex): Int = numbers.getValue(place(vertex))

    private fun along(from: Vertex, to: Vertex, vertex: Vertex): Double =
        (to.x - from.x) * (vertex.x - from.x) + (to.y - from.y) * (vertex.y - from.y) +
            (to.z - from.z) * (vertex.z - from.z)

    /** Returns the contours of what is left. */
    fun contours(): List<List<Vertex>> {
        val contours = ArrayList<List<Vertex>>()
        val parts = ArrayList<Part>()
        for (contour in cut) {
            val start = contour.indexOfFirst { it.isInPlane }
            if (start >= 0) addParts(contour, start, parts) else contours += contour.map { it.vertex }
        }
        val chains = parts.size
        addSides(parts)
        val starting = parts.groupBy { it.from }.mapValues { ArrayDeque(it.value) }
        val ending = parts.groupBy { it.until }.mapValues { ArrayDeque(it.value) }
        for (i in 0 until chains) {
            var part = parts[i]
            if (part.isUsed) continue
            val contour = ArrayList<Vertex>()
            var isReversed = false
            while (true) {
                part.isUsed = true
                contour += if (isReversed) part.vertices.drop(1).reversed() else part.vertices.dropLast(1)
                val at = if (isReversed) part.from else part.until
                if (at == parts[i].from) break

                // Only with the even-odd rule is there not always one that begins here
                val next = starting[at]?.let(::firstUnused)
                isReversed = next == null
                part = next ?: firstUnused(ending.getValue(at))!!
            }
            contours += contour
        }
        return contours
    }

    /** Returns the first of [parts] that is not used; removes those before it. */
    private fun firstUnused(parts: ArrayDeque<Part>): Part? {
        while (parts.firstOrNull()?.isUsed == true) parts.removeFirst()
        return parts.firstOrNull()
    }

    /** Adds the parts of [contour] between two corners in the plane, without sides in it; [start] is such a corner. */
    private fun addParts(contour: List<ContourCut.Corner>, start: Int, parts: MutableList<Part>) {
        var vertices = arrayListOf(contour[start].vertex)
        for (i in 1..contour.size) {
            val corner = contour[(start + i) % contour.size]
            vertices += corner.vertex
            if (!corner.isInPlane) continue
            if (vertices.size > 2) parts += Part(number(vertices.first()), number(vertices.last()), vertices)
            vertices = arrayListOf(corner.vertex)
        }
    }

    /** Adds the sides in the plane that are left. */
    private fun addSides(parts: MutableList<Part>) {
        for (i in 0 until nodes.size - 1) {
            val balance = forward[i] - backward[i]
            val count = if (fillRule == FillRule.EVEN_ODD) balance and 1 else StrictMath.abs(balance)
            repeat(count) {
                val (from, until) = if (balance > 0) Pair(i, i + 1) else Pair(i + 1, i)
                parts += Part(from, until, listOf(nodes[from], nodes[until]))
            }
        }
    }
}

/** Cuts points and lines by a plane. */
internal object SparseCut {
    /** Returns the points that are kept; null if there is none. */
    fun of(points: Points, plane: Section.Plane): Points? {
        val p = points.positions
        val kept = (0 until p.size / 3).filter { height(p, points.origin, it, plane) <= 0.0 }.toIntArray()
        if (kept.isEmpty()) return null
        return Points(
            VertexTransforms.gathered(p, kept, 3), points.size, points.material,
            points.normals?.let { VertexTransforms.gathered(it, kept, 3) },
            points.colors?.let { VertexTransforms.gathered(it, kept, 4) }, points.origin, points.name,
        )
    }

    /** Returns the parts of the segments that are kept; null if there is none. */
    fun of(lines: Lines, plane: Section.Plane): Lines? {
        val p = lines.positions
        val colors = lines.colors
        val positions = ArrayList<Float>()
        val shades = ArrayList<Float>()
        fun add(array: FloatArray, width: Int, a: Int, b: Int, t: Double, out: MutableList<Float>) {
            for (k in 0 until width) {
                val from = array[width * a + k].toDouble()
                out += (from + t * (array[width * b + k] - from)).toFloat()
            }
        }
        for (i in lines.segments.indices step 2) {
            val a = lines.segments[i]
            val b = lines.segments[i + 1]
            val heightA = height(p, lines.origin, a, plane)
            val heightB = height(p, lines.origin, b, plane)
            if (!(heightA <= 0.0 || heightB <= 0.0)) continue
            val t = heightA / (heightA - heightB)
            for (place in listOf(if (heightA > 0.0) t else 0.0, if (heightB > 0.0) t else 1.0)) {
                add(p, 3, a, b, place, positions)
                if (colors != null) add(colors, 4, a, b, place, shades)
            }
        }
        if (positions.isEmpty()) return null
        val segments = IntArray(positions.size / 3) { it }
        val all = if (colors == null) null else shades.toFloatArray()
        return Lines(positions.toFloatArray(), segments, lines.width, lines.material, all, lines.origin, lines.name)
    }

    private fun height(p: FloatArray, origin: Vector3dc, i: Int, plane: Section.Plane): Double =
        plane.height(p[3 * i] + origin.x(), p[3 * i + 1] + origin.y(), p[3 * i + 2] + origin.z())
}
