package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.gltf.document.GltfCompressedViews
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.SpecularGlossiness
import dev.lazyz.scenes.gltf.geometry.GltfInstances
import dev.lazyz.scenes.gltf.geometry.GltfNodes
import dev.lazyz.scenes.gltf.geometry.GltfVertices
import dev.lazyz.scenes.gltf.geometry.RelativeToCenter
import dev.lazyz.scenes.gltf.materials.GltfTextures

/** The supported extensions (section 3.12). */
internal object GltfExtensions {
    /** The extension for lights, see [GltfLights]. */
    const val LIGHTS: String = "KHR_lights_punctual"

    private val known = setOf(
        "KHR_materials_unlit",
        "KHR_materials_emissive_strength",
        "KHR_texture_transform",
        "KHR_mesh_quantization",
        GltfVertices.DRACO,
        LIGHTS,
        SpecularGlossiness.NAME,
        GltfInstances.NAME,
        GltfNodes.VISIBILITY,
        RelativeToCenter.NAME,
    ) + GltfCompressedViews.NAMES + GltfTextures.formats.keys

    private const val MOST_SHOWN = 20

    /**
     * Prefixes of extensions that change only the appearance: without them the shapes are right, but colours may
     * differ.
     */
    private val appearance =
        listOf("KHR_materials_", "KHR_techniques_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "EXT_lights_")

    /** Fails if the file requires an unsupported extension without which its shapes cannot be read. */
    fun check(document: GltfDocument) {
        for (name in document.json.extensionsRequired) {
            if (name in known || appearance.any { name.startsWith(it) }) continue
            document.source.fail(
                "extensionsRequired",
                "the file requires the extension $name, which is not known",
                "export the model without it",
            )
        }
    }

    /** Reports the unsupported extensions that the file uses, in one warning. */
    fun warnOfUnknown(document: GltfDocument) {
        val unknown = (document.json.extensionsUsed + document.json.extensionsRequired).distinct() - known
        if (unknown.isEmpty()) return
        val shown = unknown.take(MOST_SHOWN).joinToString() + if (unknown.size > MOST_SHOWN) " and others" else ""
        document.warn("extensions that are not known are passed over, ${unknown.size} in all: $shown")
    }
}
