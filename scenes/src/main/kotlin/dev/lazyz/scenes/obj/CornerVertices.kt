package dev.lazyz.scenes.obj

import dev.lazyz.geometry.DistinctTriples

/**
 * Numbers the different corners of faces: two corners with the same position, texture coordinate and normal are one
 * vertex. Not thread safe.
 *
 * @param expected how many vertices to make room for
 */
internal class CornerVertices(expected: Int) {
    private val corners = DistinctTriples(expected)

    /** How many vertices there are. */
    val size: Int get() = corners.size

    /** Returns the number of the vertex of this corner, a new one if there is none yet; -1 stands for what it has not. */
    fun vertex(position: Int, texture: Int, normal: Int): Int = corners.add(position, texture, normal)

    fun position(vertex: Int): Int = corners.get(vertex, 0)

    /** Returns x, y, z of each vertex out of those of all positions. */
    fun positions(from: FloatArray): FloatArray = gather(from, 0, 3)

    /** Returns u, v of each vertex out of those of all texture coordinates; 0 where it has none. */
    fun textures(from: FloatArray): FloatArray = gather(from, 1, 2)

    /** Returns x, y, z of each vertex out of those of all normals. */
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
