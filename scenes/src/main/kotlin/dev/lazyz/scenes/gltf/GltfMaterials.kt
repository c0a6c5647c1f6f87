package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.Material as MaterialJson
import dev.lazyz.Rgba
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Material
import dev.lazyz.world.Shading
import dev.lazyz.world.Sides

/**
 * A material and the source of its texture coordinates.
 *
 * @property texCoordSet number of the set, as in `TEXCOORD_0`
 * @property transform the transform to apply to the coordinates
 */
internal class GltfMaterial(val material: Material, val texCoordSet: Int, val transform: TextureTransform)

/**
 * Converts materials (section 3.9) to Blinn-Phong materials. Factors are already linear.
 *
 * - The base colour becomes the diffuse colour, also for metals: there is no environment to reflect, so they would
 *   otherwise be black.
 * - The highlight has the exponent `n = 2 / roughness^4 - 2` (B. Walter et al., "Microfacet Models for Refraction",
 *   2007, section 5.2), clamped to 1..1024, and the colour `F0 (n + 2) / 8 (1 - roughness)`, at most 1. F0 is the
 *   reflectance at normal incidence: 0.04, or the base colour of an untextured metal. `(n + 2) / 8` is the peak of a
 *   lobe of that width (N. Hoffman, "Crafting Physically Motivated Shading Models for Game Development", SIGGRAPH
 *   2010). `1 - roughness` fades the highlight out where the lobe is as wide as diffuse reflection.
 * - A material with an emissive texture emits no light, because the factor alone would make the whole surface glow.
 *   Metallic-roughness, normal and occlusion textures are not used either. [GltfOmissions] warns of all four.
 * - `KHR_materials_unlit` becomes [Shading.CONSTANT].
 */
internal class GltfMaterials(private val document: GltfDocument) {
    private val textures = GltfTextures(document)
    private val materials = HashMap<Int?, GltfMaterial>()

    /**
     * Returns the material with number [index], or the specification's default material if it is null. [where] is the
     * place that refers to it.
     */
    fun material(index: Int?, where: String): GltfMaterial {
        if (index == null) return materials.getOrPut(null) { read(MaterialJson(), "") }
        val json = document.element(document.json.materials, index, "materials", where)
        return materials.getOrPut(index) { read(json, "materials[$index]") }
    }

    private fun read(json: MaterialJson, where: String): GltfMaterial {
        val pbr = json.pbrMetallicRoughness
        val info = pbr?.baseColorTexture
        val transform = TextureTransform.of(info)
        val texture = info?.let { textures.texture(it.index, "$where.pbrMetallicRoughness.baseColorTexture.index") }
        val base = color(pbr?.baseColorFactor, Rgba.WHITE)
        val roughness = fraction(pbr?.roughnessFactor, 1f)
        val metallic = if (texture == null) fraction(pbr?.metallicFactor, 1f) else 0f
        val shininess = shininess(roughness)
        val isUnlit = GltfExtensions.of(json, "KHR_materials_unlit") != null
        val material = Material(
            baseColor = base,
            texture = texture,
            shading = if (isUnlit) Shading.CONSTANT else Shading.BLINN_PHONG,
            specular = specular(base, metallic, roughness, shininess),
            shininess = shininess,
            emission = emission(json),
            alphaMode = alphaMode(json, where),
            alphaCutoff = fraction(json.alphaCutoff, 0.5f),
            sides = if (json.isDoubleSided == true) Sides.BOTH else Sides.FRONT,
            name = json.name ?: "",
        )
        return GltfMaterial(material, transform.texCoordSet ?: info?.texCoord ?: 0, transform)
    }

    private fun shininess(roughness: Float): Int {
        val square = roughness.toDouble() * roughness
        val exponent = 2.0 / (square * square) - 2.0
        return if (exponent < 1024.0) StrictMath.rint(exponent).toInt().coerceAtLeast(1) else 1024
    }

    private fun specular(base: Rgba, metallic: Float, roughness: Float, shininess: Int): Rgba {
        val reflectance = listOf(base.red, base.green, base.blue).map { DIELECTRIC * (1f - metallic) + it * metallic }
        val strength = (shininess + 2) / 8f * (1f - roughness)
        val most = 1f / maxOf(reflectance.max(), DIELECTRIC)
        return Rgba(reflectance[0], reflectance[1], reflectance[2]).scaled(minOf(strength, most))
    }

    private fun emission(json: MaterialJson): Rgba {
        if (json.emissiveTexture != null) return Rgba.BLACK
        val color = color(json.emissiveFactor, Rgba.BLACK)
        val strength = GltfExtensions.of(json, "KHR_materials_emissive_strength")
        return if (strength ==
            null
        ) {
            color
        } else {
            color.scaled(GltfExtensions.number(strength, "emissiveStrength", 1.0).toFloat())
        }
    }

    private fun alphaMode(json: MaterialJson, where: String): AlphaMode = when (json.alphaMode) {
        null, "OPAQUE" -> AlphaMode.OPAQUE
        "MASK" -> AlphaMode.MASK
        "BLEND" -> AlphaMode.BLEND
        else -> AlphaMode.OPAQUE.also {
            document.warn("$where.alphaMode ${json.alphaMode} is unknown and taken as OPAQUE")
        }
    }

    private fun color(factors: FloatArray?, missing: Rgba): Rgba =
        if (factors == null ||
            factors.size < 3
        ) {
            missing
        } else {
            Rgba(factors[0], factors[1], factors[2], factors.getOrElse(3) { 1f })
        }

    private fun fraction(number: Float?, missing: Float): Float =
        number?.takeIf { it.isFinite() }?.coerceIn(0f, 1f) ?: missing

    private companion object {
        /** Reflectance of dielectrics such as glass and plastic, appendix B.2. */
        const val DIELECTRIC = 0.04f
    }
}
