package dev.lazyz.scenes.obj

import dev.lazyz.scenes.triangulation.Ints

/**
 * Numbers the different corners of faces: two corners with the same position, texture coordinate and normal are one
 * vertex. A chain of vertices hangs on each position. Not thread safe.
 *
 * @param positionCount how many positions the file has
 */
internal class CornerVertices(positionCount: Int) {
    private val firstAt = IntArray(positionCount) { -1 }
    private val next = Ints()

    /** By vertex: numbers of its position, texture coordinate and normal; -1 for none. */
    val positions = Ints()
    val textures = Ints()
    val normals = Ints()

    /** Returns the number of the vertex of this corner, a new one if there is none yet. */
    fun vertex(position: Int, texture: Int, normal: Int): Int {
        var vertex = firstAt[position]
        while (vertex >= 0) {
            if (textures[vertex] == texture && normals[vertex] == normal) return vertex
            vertex = next[vertex]
        }
        next.add(firstAt[position])
        positions.add(position)
        textures.add(texture)
        normals.add(normal)
        firstAt[position] = positions.size - 1
        return positions.size - 1
    }

    /** Forgets all vertices. Cost: linear in their number. */
    fun clear() {
        for (vertex in 0 until positions.size) firstAt[positions[vertex]] = -1
        next.clear()
        positions.clear()
        textures.clear()
        normals.clear()
    }
}
