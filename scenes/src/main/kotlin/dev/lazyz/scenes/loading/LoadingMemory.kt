package dev.lazyz.scenes.loading

import dev.lazyz.scenes.SceneFormat

/** What reading a file takes of Java's memory, with room for the garbage collector; measured on meshes that need much. */
internal object LoadingMemory {
    /** Bytes of memory for each byte of a file of [format]; what any file takes if it is null. */
    fun perByte(format: SceneFormat?): Int = when (format) {
        // A triangle is 50 bytes, and takes 80 while it gets its normals
        SceneFormat.STL -> 3

        // A triangle of a strip is 4 bytes, and takes some 40 while it is read
        SceneFormat.PLY -> 5
        SceneFormat.OBJ, SceneFormat.OFF -> 8
        SceneFormat.GLTF, SceneFormat.GLB, SceneFormat.SCENE -> 4

        // What is packed counts when it is unpacked
        SceneFormat.THREE_MF -> 4
        null -> 2
    }

    /** Least bytes of memory for making the smooth normals of so many triangles and vertices, with the mesh. */
    fun normals(triangles: Long, vertices: Long): Long = 36 * triangles + 50 * vertices
}
