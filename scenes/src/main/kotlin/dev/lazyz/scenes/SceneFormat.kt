package dev.lazyz.scenes

import dev.lazyz.geometry.UpAxis

/**
 * The file formats that a scene can be read from.
 *
 * @property id lower-case name, used on command lines
 * @property extensions file name extensions, lower case, without a dot
 */
public enum class SceneFormat(public val id: String, public val extensions: List<String>) {
    /** Wavefront OBJ, with its MTL material libraries. */
    OBJ("obj", listOf("obj")),

    /** Stereolithography, ASCII or binary; the content decides which. */
    STL("stl", listOf("stl")),

    /** Polygon File Format, ASCII or binary of either byte order. */
    PLY("ply", listOf("ply")),

    /** Object File Format of Geomview, ASCII. */
    OFF("off", listOf("off")),

    /** 3D Manufacturing Format. */
    THREE_MF("3mf", listOf("3mf")),

    /** glTF 2.0 as JSON with separate or embedded buffers. */
    GLTF("gltf", listOf("gltf")),

    /** glTF 2.0 in one binary file. */
    GLB("glb", listOf("glb")),

    /** Lazy Z's scene file format, JSON. */
    SCENE("scene", listOf("json")),
    ;

    /** The axis that points up in most files of this format: parts for machines lie on the plane of x and y. */
    public val usualUp: UpAxis get() = if (this == STL || this == THREE_MF) UpAxis.Z else UpAxis.Y

    public companion object {
        /**
         * Returns the bytes of memory for each byte of a file of [format] while it is read, including a reserve for the
         * garbage collector; if it is null, the minimum for any format. Measured on meshes that need much of it.
         */
        internal fun memoryPerByte(format: SceneFormat?): Int = when (format) {
            // A triangle is 50 bytes in the file, and takes 80 while its normals are computed
            STL -> 3

            // A triangle of a strip is 4 bytes in the file, and takes about 40 while it is read
            PLY -> 5
            OBJ, OFF -> 8

            // Compressed data is counted when it is decompressed
            GLTF, GLB, SCENE, THREE_MF -> 4
            null -> 2
        }

        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): SceneFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
