package dev.lazyz.sections

import dev.lazyz.Checkpoint
import dev.lazyz.endIfInterrupted
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.geometry.FaceNormal
import dev.lazyz.sections.Section
import dev.lazyz.world.surface.Mesh

/**
 * One mesh and one plane: what remains of the mesh, and the contours of the cut. A point between two vertices depends
 * only on their positions, so triangles that meet, also those of different meshes, get the same bits. Not thread safe.
 */
internal class MeshCut(private val mesh: Mesh, plane: Section.Plane) {
    private val p = mesh.positions
    private val triangles = mesh.triangles

    /** By vertex: its distance from the plane, positive on the removed side; NaN if a coordinate is NaN. */
    private val heights = DoubleArray(mesh.vertexCount) {
        val origin = mesh.origin
        plane.height(p[3 * it] + origin.x(), p[3 * it + 1] + origin.y(), p[3 * it + 2] + origin.z())
    }
    private val normal = plane.normal
    private val face = FaceNormal(p, triangles)

    private fun isOut(vertex: Int) = heights[vertex] > 0.0

    /** Whether the triangle that begins at index [i] is removed: no part of it is kept, or it is the bottom of one. */
    private fun isRemoved(i: Int): Boolean = (0 until 3).all { isOut(triangles[i + it]) } || isCeiling(i)

    /** Whether the triangle is in the plane and shows its front to the kept side. */
    private fun isCeiling(i: Int): Boolean {
        if ((0 until 3).any { heights[triangles[i + it]] != 0.0 }) return false
        face.compute(i)
        return normal.x() * face.x + normal.y() * face.y + normal.z() * face.z < 0.0
    }

    private fun isCrossing(i: Int): Boolean =
        (0 until 3).any { isOut(triangles[i + it]) } && (0 until 3).any { heights[triangles[i + it]] <= 0.0 }

    /** Where the side from vertex [a] to vertex [b] crosses the plane, as a fraction; both get the same point. */
    private fun place(a: Int, b: Int): Double = heights[a] / (heights[a] - heights[b])

    /** Whether the position of [a] comes before that of [b] in a fixed order. */
    private fun isBefore(a: Int, b: Int): Boolean {
        for (k in 0 until 3) if (p[3 * a + k] != p[3 * b + k]) return p[3 * a + k] < p[3 * b + k]
        return a < b
    }

    private fun mixed(array: FloatArray, width: Int, a: Int, b: Int, k: Int): Float {
        val from = array[width * a + k].toDouble()
        return (from + place(a, b) * (array[width * b + k] - from)).toFloat()
    }

    /** Returns the kept part of the mesh; null if nothing is kept. */
    fun kept(): Mesh? {
        if (triangles.indices.step(3).none { isRemoved(it) || isCrossing(it) }) return mesh

        // Copy what is kept. A vertex is a vertex of the mesh, or is between two of them, in their order
        val vertices = DistinctTriples()
        var corners = IntArray(triangles.size + 16)
        var count = 0
        val outline = IntArray(4)
        for (i in triangles.indices step 3) {
            if (Checkpoint.isDue(i)) endIfInterrupted()
            if (isRemoved(i)) continue
            var size = 0
            for (k in 0 until 3) {
                val a = triangles[i + k]
                val b = triangles[i + (k + 1) % 3]
                if (!isOut(a)) outline[size++] = vertices.add(a, a, 0)
                if (isOut(a) != isOut(b) && heights[if (isOut(a)) b else a] != 0.0) {
                    outline[size++] = between(vertices, a, b)
                }
            }
            if (count + 6 > corners.size) corners = corners.copyOf(corners.size + corners.size / 2)
            for (k in 2 until size) {
                corners[count++] = outline[0]
                corners[count++] = outline[k - 1]
                corners[count++] = outline[k]
            }
        }
        if (count == 0) return null
        return mesh.mapped(corners.copyOf(count)) { numbers, width -> gathered(vertices, numbers, width) }
    }

    private fun between(vertices: DistinctTriples, a: Int, b: Int): Int =
        if (isBefore(a, b)) vertices.add(a, b, 0) else vertices.add(b, a, 0)

    private fun gathered(vertices: DistinctTriples, array: FloatArray, width: Int): FloatArray {
        val result = FloatArray(width * vertices.size)
        for (i in 0 until vertices.size) {
            val a = vertices.get(i, 0)
            val b = vertices.get(i, 1)
            for (k in 0 until width) {
                result[width * i + k] = if (a == b) array[width * a + k] else mixed(array, width, a, b, k)
            }
        }
        return result
    }

    /**
     * Adds the segments in which the triangles cross the plane to [contours], directed so that what is left of them,
     * seen from the removed side, is inside.
     */
    fun addSegments(contours: Contours) {
        for (i in triangles.indices step 3) {
            if (Checkpoint.isDue(i)) endIfInterrupted()
            if (isCeiling(i)) {
                for (k in 0 until 3) contours.add(point(triangles[i + k]), point(triangles[i + (k + 1) % 3]))
                continue
            }
            if (!isCrossing(i)) continue
            var entry: FloatArray? = null
            var exit: FloatArray? = null
            for (k in 0 until 3) {
                val a = triangles[i + k]
                val b = triangles[i + (k + 1) % 3]
                if (isOut(a) && heights[b] <= 0.0) entry = crossing(a, b)
                if (heights[a] <= 0.0 && isOut(b)) exit = crossing(a, b)
            }
            if (entry != null && exit != null) contours.add(entry, exit)
        }
    }

    private fun point(vertex: Int) = FloatArray(3) { p[3 * vertex + it] }

    private fun crossing(a: Int, b: Int): FloatArray = when {
        heights[a] == 0.0 -> point(a)
        heights[b] == 0.0 -> point(b)
        isBefore(a, b) -> FloatArray(3) { mixed(p, 3, a, b, it) }
        else -> FloatArray(3) { mixed(p, 3, b, a, it) }
    }
}
