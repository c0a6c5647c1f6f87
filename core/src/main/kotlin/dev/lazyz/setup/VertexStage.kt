package dev.lazyz.setup

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.surface.Mesh

/**
 * The transforms of all vertices of a frame: from world space to clip space, and to the raster. Immutable and thread
 * safe.
 */
internal class VertexStage(camera: Camera, val viewport: Viewport) {
    val clipper: Clipper = clipper(ScreenGrid.GUARD)

    /** The clipper for lines. Its guard band is smaller, because lines are widened after clipping. */
    val lineClipper: Clipper = clipper(ScreenGrid.LINE_GUARD)

    /** Whether w can differ between vertices. */
    val isPerspective: Boolean = camera.projection is Projection.Perspective

    val worldToClip = camera.clipMatrix(viewport.raster.width.toDouble() / viewport.raster.height)
    private val eye = camera.eye
    private val back = camera.toWorldDirection(0.0, 0.0, 1.0)

    /** Calls [action] with the clip-space position of the world-space point ([x], [y], [z]). */
    inline fun toClip(x: Double, y: Double, z: Double, action: (x: Double, y: Double, z: Double, w: Double) -> Unit) {
        val m = worldToClip
        action(
            m.m00 * x + m.m10 * y + m.m20 * z + m.m30,
            m.m01 * x + m.m11 * y + m.m21 * z + m.m31,
            m.m02 * x + m.m12 * y + m.m22 * z + m.m32,
            m.m03 * x + m.m13 * y + m.m23 * z + m.m33,
        )
    }

    /** Sets the clip-space position and the world position of [vertex] from the world-space point ([x], [y], [z]). */
    fun place(vertices: Vertices, vertex: Int, x: Double, y: Double, z: Double) {
        toClip(x, y, z) { clipX, clipY, clipZ, clipW ->
            vertices.set(vertex, Vertices.X, clipX)
            vertices.set(vertex, Vertices.Y, clipY)
            vertices.set(vertex, Vertices.Z, clipZ)
            vertices.set(vertex, Vertices.W, clipW)
        }
        vertices.set(vertex, Vertices.WORLD, x)
        vertices.set(vertex, Vertices.WORLD + 1, y)
        vertices.set(vertex, Vertices.WORLD + 2, z)
    }

    /** Sets position and attributes of [vertex] to those of vertex [from] of [mesh]. */
    fun place(vertices: Vertices, vertex: Int, mesh: Mesh, from: Int) {
        val p = mesh.positions
        place(vertices, vertex, p[3 * from].toDouble(), p[3 * from + 1].toDouble(), p[3 * from + 2].toDouble())
        vertices.setAttributes(vertex, mesh, from)
    }

    /** Positive if the viewer is on the side that [normal] points to, for a face with this vertex. */
    fun towardEye(vertices: Vertices, vertex: Int, normal: DoubleArray): Double = towardEye(
        vertices.get(vertex, Vertices.WORLD), vertices.get(vertex, Vertices.WORLD + 1),
        vertices.get(vertex, Vertices.WORLD + 2), normal[0], normal[1], normal[2],
    )

    /** Positive if the viewer is on the side that the normal points to, at the world-space point ([x], [y], [z]). */
    fun towardEye(x: Double, y: Double, z: Double, normalX: Double, normalY: Double, normalZ: Double): Double {
        if (!isPerspective) return normalX * back.x + normalY * back.y + normalZ * back.z
        return normalX * (eye.x() - x) + normalY * (eye.y() - y) + normalZ * (eye.z() - z)
    }

    private fun clipper(guard: Int) = Clipper(viewport.guardX(guard), viewport.guardY(guard), viewport.near)
}

/**
 * Clips polygons at the near plane, the far plane and the guard band, in homogeneous space (contract rule 9).
 *
 * Source: Ivan Sutherland and Gary Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17 (1974), applied
 * to each contour. There are two refinements. A cut is computed in the same way for both directions of an edge, so that
 * both polygons at the edge get the same point. And where a contour continues along the plane, from the cut where it
 * leaves to the cut where it returns, all other cuts between them become vertices of it. So overlapping parts have the
 * same end points, and cancel exactly after snapping.
 *
 * @param guardX the guard band: inside is -guardX w <= x <= guardX w
 * @param guardY the guard band: inside is -guardY w <= y <= guardY w
 * @param near the near plane: inside is near w <= z <= w
 */
internal class Clipper(private val guardX: Double, private val guardY: Double, private val near: Double) {
    /** Returns a bit for each plane that [vertex] is outside of; 0 if it is inside all planes. */
    fun outcode(vertices: Vertices, vertex: Int): Int {
        var code = 0
        for (plane in 0 until PLANES) if (distance(vertices, vertex, plane) < 0.0) code = code or (1 shl plane)
        return code
    }

    /** Whether a position in clip space is inside all planes, finite, and in front of the eye. */
    fun isInside(x: Double, y: Double, z: Double, w: Double): Boolean =
        w > 0.0 && w < Double.POSITIVE_INFINITY && z - near * w >= 0.0 && w - z >= 0.0 &&
            guardX * w + x >= 0.0 && guardX * w - x >= 0.0 && guardY * w + y >= 0.0 && guardY * w - y >= 0.0

    /**
     * Clips the contours at the planes in [planes] (bits as in [outcode]); appends new vertices to [vertices].
     *
     * @return the clipped contours, without empty ones
     */
    fun clip(vertices: Vertices, contours: List<IntArray>, planes: Int): List<IntArray> {
        var left = contours
        for (plane in 0 until PLANES) if (planes and (1 shl plane) != 0) left = clipAt(vertices, left, plane)
        return left
    }

    /**
     * Clips the segment between two vertices at all planes; appends new vertices to [vertices].
     *
     * @return the ends of the clipped segment, in its direction, or null if it is empty
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

    /**
     * Inserts the other cuts into each part of [contour] that runs along the plane. Cuts are the vertices from
     * [firstCut] on.
     */
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

    /** Position of [cut] on the part from [from] to [to], on the screen, in arbitrary units. */
    private fun along(vertices: Vertices, from: Int, to: Int, cut: Int): Double {
        val fromX = vertices.get(from, Vertices.X) / vertices.get(from, Vertices.W)
        val fromY = vertices.get(from, Vertices.Y) / vertices.get(from, Vertices.W)
        val runX = vertices.get(to, Vertices.X) / vertices.get(to, Vertices.W) - fromX
        val runY = vertices.get(to, Vertices.Y) / vertices.get(to, Vertices.W) - fromY
        val cutX = vertices.get(cut, Vertices.X) / vertices.get(cut, Vertices.W) - fromX
        val cutY = vertices.get(cut, Vertices.Y) / vertices.get(cut, Vertices.W) - fromY
        return runX * cutX + runY * cutY
    }

    /** Distance of [vertex] from [plane], in arbitrary units; negative outside. Linear in the position. */
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
