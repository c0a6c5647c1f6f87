package dev.lazyz.scenes.gltf.document

import dev.lazyz.scenes.json.JsonList
import dev.lazyz.scenes.json.JsonMap

/**
 * Converts materials of `KHR_materials_pbrSpecularGlossiness` to metallic-roughness materials, in the JSON.
 *
 * Without textures, the conversion is that of the Khronos Group (examples of the extension, "Convert between
 * workflows"): a material whose specular colour is brighter than that of dielectrics becomes partly or fully metallic.
 *
 * A material with textures becomes a dielectric with the diffuse colour as base colour. `GltfLobes` adds the reflection
 * of the specular colour, and `GltfMaterials` the roughness. If a material has a texture of glossiness, and also a
 * metallic-roughness texture, the metallic-roughness values of the file are used.
 */
internal object SpecularGlossiness {
    const val NAME: String = "KHR_materials_pbrSpecularGlossiness"
    const val TEXTURE: String = "specularGlossinessTexture"

    private const val METALLIC_ROUGHNESS = "pbrMetallicRoughness"
    private const val DIELECTRIC = 0.04
    private const val EPSILON = 1e-6

    /** Converts the materials in [tree], the JSON of a file. */
    fun convert(tree: JsonMap, warnings: CountedWarnings) {
        for (material in tree.list("materials").orEmpty()) {
            warnings.source.step()
            if (material !is JsonMap) continue
            val old = material.map("extensions")?.map(NAME) ?: continue
            val isTextured = TEXTURE in old
            val metallicRoughness = material.map(METALLIC_ROUGHNESS)
            if (isTextured && metallicRoughness != null && "metallicRoughnessTexture" in metallicRoughness) continue
            material[METALLIC_ROUGHNESS] = converted(old)
        }
    }

    private fun converted(old: JsonMap): JsonMap {
        val new = JsonMap()
        val diffuse = fractions(old["diffuseFactor"], 4)
        new["roughnessFactor"] = if (TEXTURE in old) 1.0 else 1.0 - fraction(old["glossinessFactor"])
        old["diffuseTexture"]?.let { new["baseColorTexture"] = it }
        val isDielectric = TEXTURE in old || "diffuseTexture" in old
        val specular = if (isDielectric) DoubleArray(3) else fractions(old["specularFactor"], 3)
        val metallic = if (isDielectric) 0.0 else metallic(diffuse, specular)
        new["metallicFactor"] = metallic
        val base = JsonList()
        for (i in 0 until 3) base.add(if (isDielectric) diffuse[i] else base(diffuse[i], specular, i, metallic))
        base.add(diffuse[3])
        new["baseColorFactor"] = base
        return new
    }

    /** Returns the root in 0..1 of the equation that both models reflect the same. */
    private fun metallic(diffuse: DoubleArray, specular: DoubleArray): Double {
        val reflected = brightness(specular)
        if (reflected < DIELECTRIC) return 0.0
        val a = DIELECTRIC
        val b = brightness(diffuse) * (1.0 - specular.max()) / (1.0 - DIELECTRIC) + reflected - 2.0 * DIELECTRIC
        val c = DIELECTRIC - reflected
        return ((StrictMath.sqrt(b * b - 4.0 * a * c) - b) / (2.0 * a)).coerceIn(0.0, 1.0)
    }

    private fun base(diffuse: Double, specular: DoubleArray, i: Int, metallic: Double): Double {
        val strength = (1.0 - specular.max()) / (1.0 - DIELECTRIC)
        val ofDiffuse = diffuse * strength / maxOf(1.0 - metallic, EPSILON)
        val ofSpecular = (specular[i] - DIELECTRIC * (1.0 - metallic)) / maxOf(metallic, EPSILON)
        val weight = metallic * metallic
        return (ofDiffuse * (1.0 - weight) + ofSpecular * weight).coerceIn(0.0, 1.0)
    }

    private fun brightness(color: DoubleArray): Double {
        val (red, green, blue) = color
        return StrictMath.sqrt(0.299 * red * red + 0.587 * green * green + 0.114 * blue * blue)
    }

    private fun fractions(json: Any?, size: Int) = DoubleArray(size) { fraction((json as? List<*>)?.getOrNull(it)) }

    private fun fraction(json: Any?): Double = ((json as? Number)?.toDouble() ?: 1.0).coerceIn(0.0, 1.0)
}
