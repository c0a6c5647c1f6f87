package dev.lazyz.scenes.meshes

import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.surface.Mesh
import java.util.BitSet

/**
 * Computes the normals that a file does not give. A normal that is zero or not finite has no direction and counts as
 * missing: some programs write such numbers at degenerate triangles, or everywhere.
 */
internal object MissingNormals {
    private const val CORNER_BYTES = 80L

    /**
     * Returns [mesh] with smooth normals where it has none, up to creases of [creaseAngle] degrees, and with the normal
     * of the triangle where [isFlat] is true for a triangle, or the options disable smooth normals. If all normals are
     * missing, it is as if the file had none. Fails if the memory is too small.
     */
    fun computed(
        source: Source, mesh: Mesh, creaseAngle: Double,
        isFlat: (triangle: Int) -> Boolean = {
            false
        }
    ): Mesh {
        val normals = mesh.normals ?: return source.loading.smoothed(source, mesh, creaseAngle)
        val missing = missing(normals)
        if (missing.isEmpty || mesh.triangles.none(missing::get)) return mesh
        val bare = with(mesh) { Mesh(positions, triangles, material, null, uvs, colors, origin, uvs2, name = name) }
        val flat = BitSet()
        for (triangle in 0 until mesh.triangleCount) {
            source.step()
            if (!source.loading.options.smoothNormals || isFlat(triangle)) flat.set(triangle)
        }
        val areAllFlat = flat.cardinality() == mesh.triangleCount
        if (mesh.triangles.all(missing::get) && (areAllFlat || flat.isEmpty)) {
            return if (areAllFlat) bare else source.loading.smoothed(source, bare, creaseAngle)
        }
        val smooth = if (areAllFlat) bare else source.loading.smoothed(source, bare, creaseAngle)
        return combined(source, mesh, missing, flat, smooth)
    }

    /** Returns the normals of points, of which those that are missing are 0; null if all are missing. */
    fun ofPoints(normals: FloatArray?): FloatArray? {
        val missing = missing(normals ?: return null)
        if (missing.isEmpty) return normals
        if (missing.cardinality() == normals.size / 3) return null
        return FloatArray(normals.size) { if (missing.get(it / 3)) 0f else normals[it] }
    }

    /** Returns the numbers of the normals that have no direction. */
    private fun missing(normals: FloatArray): BitSet {
        val missing = BitSet()
        for (i in normals.indices step 3) {
            val x = normals[i].toDouble()
            val y = normals[i + 1].toDouble()
            val z = normals[i + 2].toDouble()
            val square = x * x + y * y + z * z
            if (!(square > 0.0 && square.isFinite())) missing.set(i / 3)
        }
        return missing
    }

    /**
     * Returns [mesh] with normals from [smooth], whose corners are the same, or of [flat] triangles, at [missing] ones.
     */
    private fun combined(source: Source, mesh: Mesh, missing: BitSet, flat: BitSet, smooth: Mesh): Mesh {
        val loading = source.loading
        val ofTriangles = if (flat.isEmpty) smooth else smooth.withSmoothNormals(0.0) { loading.look(source.name) }

        // By vertex: the one of the mesh, and those with its computed normal, or -1
        val vertices = DistinctTriples(mesh.vertexCount)
        val triangles = IntArray(mesh.triangles.size) { corner ->
            source.step()
            val vertex = mesh.triangles[corner]
            when {
                !missing.get(vertex) -> vertices.add(vertex, -1, -1)
                flat.get(corner / 3) -> vertices.add(vertex, -1, ofTriangles.triangles[corner])
                else -> vertices.add(vertex, smooth.triangles[corner], -1)
            }
        }
        source.loading.decode(source, vertices.size * CORNER_BYTES)
        val normals = FloatArray(3 * vertices.size)
        for (i in 0 until vertices.size) {
            val (from, number) = when {
                vertices.get(i, 1) >= 0 -> smooth to vertices.get(i, 1)
                vertices.get(i, 2) >= 0 -> ofTriangles to vertices.get(i, 2)
                else -> mesh to vertices.get(i, 0)
            }
            checkNotNull(from.normals).copyInto(normals, 3 * i, 3 * number, 3 * number + 3)
        }
        return mesh.withVertices(IntArray(vertices.size) { vertices.get(it, 0) }, triangles, normals)
    }
}
