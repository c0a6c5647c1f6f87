package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.GlTFProperty

/** What is known of extensions (section 3.12), which jgltf keeps as maps of maps. */
internal object GltfExtensions {
    /** Lights; they are not used, and counted in a warning of their own. */
    const val LIGHTS: String = "KHR_lights_punctual"

    private val known = setOf(
        "KHR_materials_unlit",
        "KHR_materials_emissive_strength",
        "KHR_texture_transform",
        "KHR_mesh_quantization",
        GltfVertices.DRACO,
        LIGHTS,
    ) + GltfCompressedViews.NAMES + GltfTextures.formats.keys

    private const val MOST_SHOWN = 20

    /** Without these the picture has the right shapes, and other colours. */
    private val appearance =
        listOf("KHR_materials_", "KHR_techniques_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "EXT_lights_")

    /** Fails if the file requires an extension without which its shapes cannot be read. */
    fun check(document: GltfDocument) {
        for (name in document.json.extensionsRequired.orEmpty().filterNotNull()) {
            if (name in known || appearance.any { name.startsWith(it) }) continue
            document.source.fail(
                "extensionsRequired",
                "the file requires the extension $name, which is not known",
                "export the model without it",
            )
        }
    }

    /** Warns of the extensions that the file uses and that are not known. */
    fun warnOfUnknown(document: GltfDocument) {
        val used: List<String?> = document.json.extensionsUsed.orEmpty() + document.json.extensionsRequired.orEmpty()
        val unknown = used.filterNotNull().distinct() - known
        if (unknown.isEmpty()) return
        val shown = unknown.take(MOST_SHOWN).joinToString() + if (unknown.size > MOST_SHOWN) " and others" else ""
        document.warn("extensions that are not known are passed over, ${unknown.size} in all: $shown")
    }

    /** Returns an extension's object on [property], or null. */
    fun of(property: GlTFProperty?, name: String): Map<*, *>? = property?.extensions?.get(name) as? Map<*, *>

    /** Returns a number in an extension's object, or [missing]. */
    fun number(extension: Map<*, *>, name: String, missing: Double): Double =
        (extension[name] as? Number)?.toDouble()?.takeIf { it.isFinite() } ?: missing

    /** Returns a pair of numbers in an extension's object, or [missing] twice. */
    fun pair(extension: Map<*, *>, name: String, missing: Double): List<Double> =
        List(2) {
            ((extension[name] as? List<*>)?.getOrNull(it) as? Number)?.toDouble()?.takeIf { n -> n.isFinite() }
                ?: missing
        }
}
