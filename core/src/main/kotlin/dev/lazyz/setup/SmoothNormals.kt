package dev.lazyz.setup

import dev.lazyz.Mesh

/**
 * Gives a mesh normals made of its triangles', see [Mesh.withSmoothNormals].
 *
 * Faces are added up in the order of the triangles, and vertices are numbered in the order of their first corner, so
 * that the result is the same bits whatever is done in parallel.
 */
internal class SmoothNormals(private val mesh: Mesh, private val creaseAngle: Double) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
    }

    /** By corner: the copy of its vertex, first within its chunk of positions, then within the new mesh. */
    private val triangles = IntArray(mesh.triangles.size)

    /** Returns the mesh with normals; a vertex has as many copies as its corners have different normals. */
    fun mesh(): Mesh {
        val byPosition = CornersByPosition(mesh)
        val chunks = cornerNormals(byPosition)
        return numbered(chunks, byPosition.positionOf)
    }

    private fun cornerNormals(byPosition: CornersByPosition): List<CornerNormals> {
        val firstCopy = IntArray(mesh.vertexCount) { -1 }
        val chunks = List((byPosition.count + CHUNK - 1) / CHUNK) {
            CornerNormals(mesh, creaseAngle, firstCopy, triangles)
        }
        inParallel(chunks.size) { chunk ->
            for (position in chunk * CHUNK until minOf((chunk + 1) * CHUNK, byPosition.count)) {
                chunks[chunk].add(byPosition.corners, byPosition.starts[position], byPosition.starts[position + 1])
            }
        }
        return chunks
    }

    /** Numbers the copies in the order of their first corner. */
    private fun numbered(chunks: List<CornerNormals>, positionOf: IntArray): Mesh {
        val numbers = Array(chunks.size) { IntArray(chunks[it].size) { -1 } }
        val sources = IntArray(chunks.sumOf { it.size })
        val normals = FloatArray(3 * sources.size)
        var count = 0
        for ((corner, vertex) in mesh.triangles.withIndex()) {
            val chunk = positionOf[vertex] / CHUNK
            val copy = triangles[corner]
            var number = numbers[chunk][copy]
            if (number < 0) {
                number = count++
                numbers[chunk][copy] = number
                sources[number] = vertex
                chunks[chunk].normals.copyInto(normals, 3 * number, 3 * copy, 3 * copy + 3)
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
        )
    }

    /** Returns the [width] numbers of each of the [vertices]. */
    private fun gathered(array: FloatArray, vertices: IntArray, width: Int): FloatArray {
        val result = FloatArray(width * vertices.size)
        for (i in vertices.indices) {
            for (k in 0 until width) result[width * i + k] = array[width * vertices[i] + k]
        }
        return result
    }

    private companion object {
        /** Positions that one thread does at a time. */
        const val CHUNK = 1 shl 16
    }
}
