package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.surface.Mesh

/**
 * Splits a mesh into groups of triangles, each with the vertices that it uses. Not thread safe.
 *
 * @param source the file of which it is, whose steps of work are counted
 * @param whole the mesh; its vertices must be numbered in the order of their first use, and all must be used
 * @param groupOf number of each triangle's group, 0 until [groupCount]
 */
internal class MeshParts(
    private val source: Source,
    private val whole: Mesh,
    groupOf: Ints,
    private val groupCount: Int,
) {
    private val members = List(groupCount) { Ints() }

    /** For each vertex of the whole mesh: its number in the current part, or -1. */
    private val newNumber = IntArray(if (groupCount == 1) 0 else whole.vertexCount) { -1 }

    init {
        if (groupCount > 1) {
            for (triangle in 0 until whole.triangleCount) {
                source.step()
                members[groupOf[triangle]].add(triangle)
            }
        }
    }

    /** Returns the triangles of [group], in order; the whole mesh if there is only one group. */
    fun part(group: Int): Mesh {
        if (groupCount == 1) return whole

        // Renumber the vertices in the order in which they are used
        val used = Ints()
        val triangles = IntArray(3 * members[group].size)
        for (i in triangles.indices) {
            source.step()
            val vertex = whole.triangles[3 * members[group][i / 3] + i % 3]
            if (newNumber[vertex] < 0) {
                newNumber[vertex] = used.size
                used.add(vertex)
            }
            triangles[i] = newNumber[vertex]
        }
        for (i in 0 until used.size) newNumber[used[i]] = -1

        return whole.withVertices(used.toArray(), triangles)
    }
}
