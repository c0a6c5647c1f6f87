package dev.lazyz.scenes.loading

import dev.lazyz.scenes.SceneFormat

/**
 * Heap memory needed to read a file, including reserve for the garbage collector; measured on meshes that need much
 * of it.
 */
internal object LoadingMemory {
    /** Bytes of memory for each byte of a file of [format]; if null, the minimum for any format. */
    fun perByte(format: SceneFormat?): Int = when (format) {
        // A triangle is 50 bytes in the file, and takes 80 while its normals are computed
        SceneFormat.STL -> 3

        // A triangle of a strip is 4 bytes in the file, and takes about 40 while it is read
        SceneFormat.PLY -> 5
        SceneFormat.OBJ, SceneFormat.OFF -> 8
        SceneFormat.GLTF, SceneFormat.GLB, SceneFormat.SCENE -> 4

        // Compressed data is counted when it is decompressed
        SceneFormat.THREE_MF -> 4
        null -> 2
    }

    /**
     * Minimum bytes of memory for computing the smooth normals of so many triangles and vertices, including the mesh.
     */
    fun normals(triangles: Long, vertices: Long): Long = 36 * triangles + 50 * vertices
}
