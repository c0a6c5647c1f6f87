package dev.lazyz.geometry

import dev.lazyz.inParallel

/** Computes the normals of a mesh's triangles. */
internal object FaceNormals {
    /** Number of triangles in one task of a thread. */
    private const val CHUNK = 1 shl 16

    /**
     * Returns x, y, z of each triangle's normal. Its length is twice the area of the triangle. Normals that are not
     * finite are (0, 0, 0).
     */
    fun of(positions: FloatArray, triangles: IntArray): DoubleArray {
        val normals = DoubleArray(triangles.size)
        val count = triangles.size / 3
        inParallel((count + CHUNK - 1) / CHUNK) { chunk ->
            add(positions, triangles, chunk * CHUNK, minOf((chunk + 1) * CHUNK, count), normals)
        }
        return normals
    }

    private fun add(p: FloatArray, triangles: IntArray, from: Int, until: Int, normals: DoubleArray) {
        for (i in 3 * from until 3 * until step 3) {
            val a = 3 * triangles[i]
            val b = 3 * triangles[i + 1]
            val c = 3 * triangles[i + 2]
            val ux = p[b].toDouble() - p[a]
            val uy = p[b + 1].toDouble() - p[a + 1]
            val uz = p[b + 2].toDouble() - p[a + 2]
            val vx = p[c].toDouble() - p[a]
            val vy = p[c + 1].toDouble() - p[a + 1]
            val vz = p[c + 2].toDouble() - p[a + 2]
            val x = uy * vz - uz * vy
            val y = uz * vx - ux * vz
            val z = ux * vy - uy * vx
            if (x.isFinite() && y.isFinite() && z.isFinite()) {
                normals[i] = x
                normals[i + 1] = y
                normals[i + 2] = z
            }
        }
    }
}
