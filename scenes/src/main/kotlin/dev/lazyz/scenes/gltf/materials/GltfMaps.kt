package dev.lazyz.scenes.gltf.materials

import dev.lazyz.scenes.gltf.document.ExtensionValues
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.TextureInfoJson
import dev.lazyz.world.material.TextureEncoding
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.UvTransform

/**
 * The maps of one material, and the sets of texture coordinates that they use, in the order of their first use. A mesh
 * has two sets; a map with a third one is left out.
 */
internal class GltfMaps(private val document: GltfDocument, private val textures: GltfTextures) {
    private val sets = ArrayList<Int>()

    /** The numbers of the sets, as in `TEXCOORD_0`: at most two, and 0 if there are no maps. */
    val texCoordSets: List<Int> get() = sets.ifEmpty { listOf(0) }

    /** Returns the map that [info] describes, or null if there is none. [where] is its place in the file. */
    fun map(info: TextureInfoJson?, encoding: TextureEncoding, where: String): TextureMap? {
        if (info == null) return null
        val extension = info.extension("KHR_texture_transform")
        val set = (extension?.get("texCoord") as? Number)?.toInt() ?: info.texCoord ?: 0
        if (set !in sets) {
            if (sets.size == 2) {
                document.count("textures with a third set of texture coordinates are left out")
                return null
            }
            sets.add(set)
        }
        val texture = textures.texture(info.index, encoding, "$where.index") ?: return null
        return TextureMap(texture, sets.indexOf(set), extension?.let(::transform) ?: UvTransform.IDENTITY)
    }

    private fun transform(extension: Map<*, *>): UvTransform {
        val scale = ExtensionValues.pair(extension, "scale", 1.0)
        val offset = ExtensionValues.pair(extension, "offset", 0.0)
        val rotation = ExtensionValues.number(extension, "rotation", 0.0)
        return UvTransform(scale[0], scale[1], rotation * (180.0 / StrictMath.PI), offset[0], offset[1])
    }
}
