package dev.lazyz.scenes.obj

import dev.lazyz.geometry.DistinctTriples

/**
 * Merges equal corners of faces: corners with the same position, texture coordinate and normal become one vertex. Not
 * thread safe.
 *
 * @param expected number of vertices to reserve memory for
 */
internal class CornerVertices(expected: Int) {
    private val corners = DistinctTriples(expected)

    /** Number of vertices. */
    val size: Int get() = corners.size

    /**
     * Returns the number of the vertex for a corner. Adds a vertex if there is none yet. -1 stands for a missing
     * texture coordinate or normal.
     */
    fun vertex(position: Int, texture: Int, normal: Int): Int = corners.add(position, texture, normal)

    fun position(vertex: Int): Int = corners.get(vertex, 0)

    /** Returns x, y, z of each vertex, given those of all positions. */
    fun positions(from: FloatArray): FloatArray = gather(from, 0, 3)

    /** Returns u, v of each vertex, given those of all texture coordinates. They are 0 for a vertex without any. */
    fun textures(from: FloatArray): FloatArray = gather(from, 1, 2)

    /** Returns x, y, z of each vertex's normal, given those of all normals. They are 0 for a vertex without one. */
    fun normals(from: FloatArray): FloatArray = gather(from, 2, 3)

    private fun gather(from: FloatArray, place: Int, width: Int): FloatArray {
        val result = FloatArray(width * size)
        for (vertex in 0 until size) {
            val number = corners.get(vertex, place)
            if (number >= 0) from.copyInto(result, width * vertex, width * number, width * (number + 1))
        }
        return result
    }
}
