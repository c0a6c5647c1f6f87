package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.Material

/** Counts the features of a file that other viewers show and this library does not, for one warning of each kind. */
internal object GltfOmissions {
    fun count(document: GltfDocument) {
        val materials: List<Material?> = document.json.materials.orEmpty()
        val kinds = mapOf<String, (Material) -> Any?>(
            "normal maps" to { it.normalTexture },
            "metallic-roughness textures" to { it.pbrMetallicRoughness?.metallicRoughnessTexture },
            "occlusion textures" to { it.occlusionTexture },
            "emissive textures" to { it.emissiveTexture },
        )
        for ((kind, texture) in kinds) {
            document.count("$kind are not shown", materials.count { it != null && texture(it) != null })
        }
        val lights = GltfExtensions.of(document.json, GltfExtensions.LIGHTS)?.get("lights") as? List<*>
        document.count("lights of the file are not used", lights.orEmpty().size)
        GltfExtensions.warnOfUnknown(document)
    }
}
