package dev.lazyz.world.surface

import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.world.material.TextureMap.UvTransform
import kotlin.math.sqrt

/**
 * Computes the tangents of a mesh from one set of texture coordinates, in double precision, triangle after triangle.
 *
 * The tangent of a triangle is the direction in which u increases. A vertex gets the sum of those of its triangles,
 * each projected onto the plane of the vertex normal, made a unit vector, and weighted by the triangle's angle at the
 * vertex. A vertex between triangles of both orientations in the texture, at the seam of a mirrored texture, is split.
 * The bitangent points to where v decreases, upward in the image, as normal maps of glTF expect.
 *
 * Source: Morten Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008, and the tangent space that the
 * glTF specification prescribes, "MikkTSpace". Here a vertex is what the vertex numbers of the triangles say: vertices
 * that are equal, but have different numbers, get different tangents.
 */
internal class VertexTangents(private val mesh: Mesh, private val uvs: FloatArray, private val transform: UvTransform) {
    private val count = mesh.vertexCount
    private val triangles = mesh.triangles.copyOf()

    /** For each vertex, the orientation that it has by its first triangle: 1 or -1; 0 for none yet. */
    private val orientation = ByteArray(count)

    /** For each vertex, the number of its copy with the other orientation; 0 for none. */
    private val copyOf = IntArray(count)

    /** The vertex of each copy. */
    private val sources = ArrayList<Int>()
    private var sums = DoubleArray(3 * count)

    // Of the current triangle
    private val p = Array(3) { DoubleArray(3) }
    private val tangent = DoubleArray(3)
    private var sign = 0

    fun mesh(): Mesh {
        for (first in triangles.indices step 3) add(first)
        val vertices = IntArray(count + sources.size) { if (it < count) it else sources[it - count] }
        val tangents = FloatArray(4 * vertices.size)
        for ((vertex, original) in vertices.withIndex()) {
            val own = if (vertex < count) orientation[vertex].toInt() else -orientation[original]
            store(tangents, vertex, if (own < 0) -1f else 1f)
        }
        return mesh.mapped(triangles, tangents = tangents) { numbers, width ->
            if (sources.isEmpty()) numbers else VertexTransforms.gathered(numbers, vertices, width)
        }
    }

    private fun store(tangents: FloatArray, vertex: Int, w: Float) {
        val x = sums[3 * vertex]
        val y = sums[3 * vertex + 1]
        val z = sums[3 * vertex + 2]
        val length = sqrt(x * x + y * y + z * z)
        if (length > 0.0) {
            tangents[4 * vertex] = (x / length).toFloat()
            tangents[4 * vertex + 1] = (y / length).toFloat()
            tangents[4 * vertex + 2] = (z / length).toFloat()
        }
        tangents[4 * vertex + 3] = w
    }

    /** Adds the triangle whose first corner is [first] to the sums of its vertices. */
    private fun add(first: Int) {
        if (!findTangent(first)) return
        for (corner in 0 until 3) {
            val vertex = triangles[first + corner]
            if (orientation[vertex].toInt() == 0) orientation[vertex] = sign.toByte()
            val slot = if (orientation[vertex].toInt() == sign) vertex else copy(vertex)
            triangles[first + corner] = slot
            addCorner(corner, vertex, slot)
        }
    }

    private fun copy(vertex: Int): Int {
        if (copyOf[vertex] == 0) {
            copyOf[vertex] = count + sources.size
            sources.add(vertex)
            if (3 * (count + sources.size) > sums.size) sums = sums.copyOf(2 * sums.size)
        }
        return copyOf[vertex]
    }

    /** Sets [tangent] and [sign]. Returns false if the triangle has no area, in space or in the texture. */
    private fun findTangent(first: Int): Boolean {
        val u = DoubleArray(3)
        val v = DoubleArray(3)
        for (corner in 0 until 3) {
            val vertex = triangles[first + corner]
            for (k in 0 until 3) p[corner][k] = mesh.positions[3 * vertex + k].toDouble()
            u[corner] = transform.u(uvs[2 * vertex], uvs[2 * vertex + 1]).toDouble()
            v[corner] = -transform.v(uvs[2 * vertex], uvs[2 * vertex + 1]).toDouble()
        }
        val area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0])
        if (!(area > 0.0 || area < 0.0)) return false
        sign = if (area > 0.0) 1 else -1
        for (k in 0 until 3) {
            tangent[k] = sign * ((p[1][k] - p[0][k]) * (v[2] - v[0]) - (p[2][k] - p[0][k]) * (v[1] - v[0]))
        }
        val square = dot(tangent, tangent)
        return square > 0.0 && square.isFinite()
    }

    private fun addCorner(corner: Int, vertex: Int, slot: Int) {
        val normals = mesh.normals
        val normal = DoubleArray(3) { normals?.get(3 * vertex + it)?.toDouble() ?: 0.0 }
        unit(normal)
        val own = unit(projected(tangent, normal))
        val at = p[corner]
        val next = p[(corner + 1) % 3]
        val last = p[(corner + 2) % 3]
        val forth = unit(projected(DoubleArray(3) { next[it] - at[it] }, normal))
        val back = unit(projected(DoubleArray(3) { last[it] - at[it] }, normal))
        val angle = StrictMath.acos(dot(forth, back).coerceIn(-1.0, 1.0))
        for (k in 0 until 3) sums[3 * slot + k] += angle * own[k]
    }

    /** Returns [vector] without its part along the unit vector [normal]. */
    private fun projected(vector: DoubleArray, normal: DoubleArray): DoubleArray {
        val along = dot(vector, normal)
        return DoubleArray(3) { vector[it] - along * normal[it] }
    }

    /** Gives [vector] the length 1, unless it has none. */
    private fun unit(vector: DoubleArray): DoubleArray {
        val length = sqrt(dot(vector, vector))
        if (length > 0.0) for (k in 0 until 3) vector[k] /= length
        return vector
    }

    private fun dot(a: DoubleArray, b: DoubleArray): Double = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
