package dev.lazyz.scenes.obj

import dev.lazyz.Mesh
import dev.lazyz.scenes.images.withoutTexture
import dev.lazyz.scenes.triangulation.Ints

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

    /**
     * Returns the triangles of [group], in order, with a material of their own; call it once a group. Texture
     * coordinates, v upward so far, are scaled and moved as the material says and turned to v downward; unless
     * [isTextured] they and the texture fall away.
     */
    fun mesh(group: Int, material: MtlMaterial, isTextured: Boolean): Mesh {
        val part = if (groupCount == 1) whole else part(group)
        return Mesh(
            part.positions,
            part.triangles,
            if (isTextured) material.material else material.material.withoutTexture(),
            part.normals,
            if (isTextured) part.uvs?.also { place(it, material) } else null,
            part.colors,
            part.origin,
        )
    }

    private fun part(group: Int): Mesh {
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
            normals = whole.normals?.let { gather(it, used, 3) },
            uvs = whole.uvs?.let { gather(it, used, 2) },
            colors = whole.colors?.let { gather(it, used, 4) },
            origin = whole.origin,
        )
    }

    private fun place(uvs: FloatArray, material: MtlMaterial) {
        for (i in uvs.indices step 2) {
            uvs[i] = (uvs[i] * material.scaleU + material.offsetU).toFloat()
            uvs[i + 1] = (1.0 - (uvs[i + 1] * material.scaleV + material.offsetV)).toFloat()
        }
    }

    private fun gather(array: FloatArray, vertices: Ints, width: Int): FloatArray {
        val result = FloatArray(width * vertices.size)
        for (i in 0 until vertices.size) {
            array.copyInto(result, width * i, width * vertices[i], width * (vertices[i] + 1))
        }
        return result
    }
}
