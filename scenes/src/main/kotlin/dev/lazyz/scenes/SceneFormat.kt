package dev.lazyz.scenes

/**
 * The kinds of file that a scene can be read from.
 *
 * @property id name on command lines, lower case
 * @property extensions endings of file names, lower case, without a dot
 */
public enum class SceneFormat(public val id: String, public val extensions: List<String>) {
    /** Wavefront OBJ, with its MTL material libraries. */
    OBJ("obj", listOf("obj")),

    /** Stereolithography, ASCII or binary; which one is told from the content. */
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

    /** Lazy Z's own scene file, JSON. */
    SCENE("scene", listOf("json")),
    ;

    public companion object {
        /** Returns the format that a file name's ending stands for, or null. */
        @JvmStatic
        public fun ofFileName(name: String): SceneFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}
