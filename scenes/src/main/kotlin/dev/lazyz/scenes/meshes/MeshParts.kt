package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.world.Mesh

/**
 * Takes a mesh apart into groups of its triangles, each with the vertices that it uses. Not thread safe.
 *
 * @param whole its vertices are numbered in the order of their first use, and all are used
 * @param groupOf number of each triangle's group, 0 until [groupCount]
 */
internal class MeshParts(private val whole: Mesh, groupOf: Ints, private val groupCount: Int) {
    private val members = List(groupCount) { Ints() }

    /** By vertex of the whole: its number in the part at hand, or -1. */
    private val newNumber = IntArray(if (groupCount == 1) 0 else whole.vertexCount) { -1 }

    init {
        if (groupCount > 1) {
            for (triangle in 0 until whole.triangleCount) members[groupOf[triangle]].add(triangle)
        }
    }

    /** Returns the triangles of [group], in order; the whole itself if it has but one group. */
    fun part(group: Int): Mesh {
        if (groupCount == 1) return whole

        // Number the vertices anew in the order in which they are used
        val used = Ints()
        val triangles = IntArray(3 * members[group].size)
        for (i in triangles.indices) {
            val vertex = whole.triangles[3 * members[group][i / 3] + i % 3]
            if (newNumber[vertex] < 0) {
                newNumber[vertex] = used.size
                used.add(vertex)
            }
            triangles[i] = newNumber[vertex]
        }
        for (i in 0 until used.size) newNumber[used[i]] = -1

        return Mesh(
            gather(whole.positions, used, 3),
            triangles,
            whole.material,
            whole.normals?.let { gather(it, used, 3) },
            whole.uvs?.let { gather(it, used, 2) },
            whole.colors?.let { gather(it, used, 4) },
            whole.origin,
        )
    }

    private fun gather(array: FloatArray, vertices: Ints, width: Int): FloatArray {
        val result = FloatArray(width * vertices.size)
        for (i in 0 until vertices.size) {
            array.copyInto(result, width * i, width * vertices[i], width * (vertices[i] + 1))
        }
        return result
    }
}
