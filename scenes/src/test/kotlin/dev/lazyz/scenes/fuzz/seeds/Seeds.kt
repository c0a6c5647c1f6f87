package dev.lazyz.scenes.fuzz.seeds

/** Small files of each format with all that its loader reads, to begin with. */
internal object Seeds {
    /** The seeds of the format [id], or of material libraries. */
    fun of(id: String): List<ByteArray> = when (id) {
        "obj" -> ObjSeeds.models
        "mtl" -> ObjSeeds.libraries
        "stl" -> StlSeeds.all
        "ply" -> PlySeeds.all
        "gltf" -> GltfSeeds.texts
        "glb" -> GltfSeeds.binaries
        "scene" -> SceneSeeds.all
        "off" -> OffSeeds.all
        "3mf" -> ThreeMfSeeds.all
        else -> error("make seeds for $id")
    }
}
