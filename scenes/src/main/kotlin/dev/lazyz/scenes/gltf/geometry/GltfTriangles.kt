package dev.lazyz.scenes.gltf.geometry

/** The three modes that join vertices to triangles (section 3.7.2.1). */
internal object GltfTriangles {
    const val TRIANGLES = 4
    const val STRIP = 5
    const val FAN = 6

    /**
     * Returns vertex numbers, three for each triangle. All triangles have the same winding as the first. Vertices of an
     * incomplete last triangle are dropped.
     */
    fun of(mode: Int, indices: IntArray): IntArray {
        if (mode == TRIANGLES) return if (indices.size % 3 == 0) indices else indices.copyOf(indices.size / 3 * 3)
        val triangles = IntArray(3 * maxOf(indices.size - 2, 0))
        for (i in 0 until triangles.size / 3) {
            val isOdd = i % 2
            triangles[3 * i] = indices[if (mode == FAN) i + 1 else i]
            triangles[3 * i + 1] = indices[if (mode == FAN) i + 2 else i + 1 + isOdd]
            triangles[3 * i + 2] = indices[if (mode == FAN) 0 else i + 2 - isOdd]
        }
        return triangles
    }
}
