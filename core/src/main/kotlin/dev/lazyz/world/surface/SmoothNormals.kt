package dev.lazyz.world.surface

import dev.lazyz.Checkpoint
import dev.lazyz.Workers
import dev.lazyz.geometry.CornerNormals
import dev.lazyz.geometry.CornersByPosition

/**
 * Computes normals of a mesh from its triangles, see [Mesh.withSmoothNormals].
 *
 * Face normals are added in the order of the triangles, and vertices are numbered in the order of their first corner,
 * so the result does not depend on how the work is divided between threads.
 *
 * @param checkpoint may end the work; passed on the calling thread
 */
internal class SmoothNormals(
    private val mesh: Mesh,
    private val creaseAngle: Double,
    private val checkpoint: Checkpoint = Checkpoint.NONE,
) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
    }

    /** By corner: the copy of its vertex. First numbered within the chunk of positions, later within the new mesh. */
    private val triangles = IntArray(mesh.triangles.size)

    /** Returns the mesh with normals. A vertex has as many copies as its corners have different normals. */
    fun mesh(): Mesh = numbered(copies())

    /** The normals of the copies of vertices, by chunk of positions. */
    private class Copies(val positionOf: IntArray, val sizes: IntArray, val normals: List<FloatArray>)

    private fun copies(): Copies {
        val byPosition = CornersByPosition(mesh.positions, mesh.triangles, checkpoint)
        val firstCopy = IntArray(mesh.vertexCount) { -1 }
        val chunks = List((byPosition.count + CHUNK - 1) / CHUNK) {
            CornerNormals(mesh.positions, mesh.triangles, creaseAngle, firstCopy, triangles)
        }
        Workers.ALL.forEach(chunks.size, checkpoint) { chunk, own ->
            for (position in chunk * CHUNK until minOf((chunk + 1) * CHUNK, byPosition.count)) {
                val start = byPosition.starts[position]
                val end = byPosition.starts[position + 1]
                if (Checkpoint.isDue(position) || end - start > MANY) own.pass()
                chunks[chunk].add(byPosition.corners, start, end)
            }
        }
        return Copies(byPosition.positionOf, IntArray(chunks.size) { chunks[it].size }, chunks.map { it.normals })
    }

    /** Renumbers the copies in the order of their first corner, and builds the mesh. */
    private fun numbered(copies: Copies): Mesh {
        val numbers = Array(copies.sizes.size) { IntArray(copies.sizes[it]) { -1 } }
        val sources = IntArray(copies.sizes.sum())
        val normals = FloatArray(3 * sources.size)
        var count = 0
        for ((corner, vertex) in mesh.triangles.withIndex()) {
            if (Checkpoint.isDue(corner)) checkpoint.pass()
            val chunk = copies.positionOf[vertex] / CHUNK
            val copy = triangles[corner]
            var number = numbers[chunk][copy]
            if (number < 0) {
                number = count++
                numbers[chunk][copy] = number
                sources[number] = vertex
                copies.normals[chunk].copyInto(normals, 3 * number, 3 * copy, 3 * copy + 3)
            }
            triangles[corner] = number
        }
        return Mesh(
            gathered(mesh.positions, sources, 3),
            triangles,
            mesh.material,
            normals,
            mesh.uvs?.let { gathered(it, sources, 2) },
            mesh.colors?.let { gathered(it, sources, 4) },
            mesh.origin,
            mesh.uvs2?.let { gathered(it, sources, 2) },
            mesh.tangents?.let { gathered(it, sources, 4) },
            mesh.name,
        )
    }

    /** Returns the [width] numbers of each of the [vertices], in the order of [vertices]. */
    private fun gathered(array: FloatArray, vertices: IntArray, width: Int): FloatArray {
        val result = FloatArray(width * vertices.size)
        for (i in vertices.indices) {
            for (k in 0 until width) result[width * i + k] = array[width * vertices[i] + k]
        }
        return result
    }

    private companion object {
        /** Number of positions in one task of a thread. */
        const val CHUNK = 1 shl 16

        /** Number of corners at one position that take long, as each is compared with each. */
        const val MANY = 32
    }
}
