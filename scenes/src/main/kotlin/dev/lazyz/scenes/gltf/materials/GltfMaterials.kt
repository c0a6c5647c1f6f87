package dev.lazyz.scenes.gltf.materials

import dev.lazyz.Rgba
import dev.lazyz.scenes.gltf.document.ExtensionValues
import dev.lazyz.scenes.gltf.document.GlossinessJson
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.MaterialJson
import dev.lazyz.scenes.gltf.document.SpecularGlossiness
import dev.lazyz.scenes.gltf.document.TextureInfoJson
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import kotlin.math.round

/**
 * A material and the sets of texture coordinates of its maps.
 *
 * @property texCoordSets numbers of at most two sets, as in `TEXCOORD_0`; the maps of the [material] refer to the first
 *   as 0 and to the second as 1
 */
internal class GltfMaterial(val material: Material, val texCoordSets: List<Int>)

/**
 * Converts materials (section 3.9): to metallic-roughness materials with [GltfLobes], or with `KHR_materials_unlit` to
 * [Shading.CONSTANT]. Factors are already linear.
 *
 * A classical look is added, for callers who remove the metallic-roughness model to see another shading:
 *
 * - The base colour is the diffuse colour, also of metals.
 * - The highlight has the exponent `n = 2 / roughness^4 - 2` (B. Walter et al., "Microfacet Models for Refraction",
 *   2007, section 5.2), clamped to 1..1024, and the colour `F0 (n + 2) / 8 (1 - roughness)`, at most 1. F0 is the
 *   reflectance at normal incidence: 0.04, or the base colour of an untextured metal. `(n + 2) / 8` is the peak of a
 *   lobe of that width (N. Hoffman, "Crafting Physically Motivated Shading Models for Game Development", SIGGRAPH
 *   2010). `1 - roughness` fades the highlight out where the lobe is as wide as diffuse reflection.
 */
internal class GltfMaterials(private val document: GltfDocument) {
    private val textures = GltfTextures(document)
    private val materials = HashMap<Int?, GltfMaterial>()

    /**
     * Returns the material with number [index], or the specification's default material if it is null. [where] is the
     * place that refers to it.
     */
    fun material(index: Int?, where: String): GltfMaterial {
        if (index == null) return materials.getOrPut(null) { read(MaterialJson(null), "") }
        val json = document.element(document.json.materials, index, "materials", where)
        return materials.getOrPut(index) { read(json, "materials[$index]") }
    }

    private fun read(json: MaterialJson, where: String): GltfMaterial {
        val pbr = json.pbrMetallicRoughness
        val maps = GltfMaps(document, textures)
        val here = "$where.pbrMetallicRoughness"
        val base = color(pbr?.baseColorFactor, Rgba.WHITE)
        val baseMap = maps.map(pbr?.baseColorTexture, Texture.Encoding.SRGB, "$here.baseColorTexture")
        val roughness = pbr?.roughnessFactor ?: 1f
        val metallic = pbr?.metallicFactor ?: 1f
        val shininess = shininess(roughness)
        val isUnlit = json.extension("KHR_materials_unlit") != null
        val plain = Material(
            baseColor = base,
            shading = if (isUnlit) Shading.CONSTANT else Shading.BLINN_PHONG,
            specular = specular(base, if (baseMap == null) metallic else 0f, roughness, shininess),
            shininess = shininess,
            alphaMode = json.alphaMode?.let(AlphaMode::valueOf) ?: AlphaMode.OPAQUE,
            alphaCutoff = json.alphaCutoff?.takeIf { it.isFinite() }?.let { minOf(it, 1f) } ?: 0.5f,
            sides = if (json.doubleSided == true) Sides.BOTH else Sides.FRONT,
            name = json.name ?: "",
        ).withTextureMap(baseMap)
        if (isUnlit) return GltfMaterial(plain, maps.texCoordSets)

        val modelMap =
            maps.map(pbr?.metallicRoughnessTexture, Texture.Encoding.LINEAR, "$here.metallicRoughnessTexture")
                ?: roughness(json.glossiness, maps, "$where.extensions.${SpecularGlossiness.NAME}")
        val normalMap = maps.map(json.normalTexture, Texture.Encoding.LINEAR, "$where.normalTexture")
        val normalScale = json.normalTexture?.scale?.takeIf { it.isFinite() } ?: 1f
        val occlusionMap = maps.map(json.occlusionTexture, Texture.Encoding.LINEAR, "$where.occlusionTexture")
        val occlusionStrength = json.occlusionTexture?.strength ?: 1f
        val emissionMap = maps.map(json.emissiveTexture, Texture.Encoding.SRGB, "$where.emissiveTexture")
        val lobes = GltfLobes(json, maps, where).read()
        val material = glass(plain, lobes)
            .withMetallicRoughness(MetallicRoughness(metallic, roughness, modelMap, lobes))
            .withNormalMap(normalMap?.let { NormalMap(it, normalScale) })
            .withOcclusionMap(occlusionMap?.let { OcclusionMap(it, occlusionStrength) })
            .withEmission(emission(json))
            .withEmissionMap(emissionMap)
        return GltfMaterial(material, maps.texCoordSets)
    }

    /** Returns the roughness that belongs to a map of glossiness. */
    private fun roughness(json: GlossinessJson?, maps: GltfMaps, where: String): TextureMap? {
        val map =
            maps.map(json?.texture, Texture.Encoding.LINEAR, "$where.${SpecularGlossiness.TEXTURE}") ?: return null
        return map.withTexture(textures.roughness(map.texture, json?.factor ?: 1f))
    }

    /** Returns [material] as a translucent one if light passes and its alpha has no meaning of its own. */
    private fun glass(material: Material, lobes: Lobes?): Material {
        if (lobes?.transmission == null || material.alphaMode != AlphaMode.OPAQUE) return material
        return material.withAlphaMode(AlphaMode.BLEND).withBaseColor(material.baseColor.withAlpha(1f))
    }

    private fun shininess(roughness: Float): Int {
        val square = roughness.toDouble() * roughness
        val exponent = 2.0 / (square * square) - 2.0
        return if (exponent < 1024.0) round(exponent).toInt().coerceAtLeast(1) else 1024
    }

    private fun specular(base: Rgba, metallic: Float, roughness: Float, shininess: Int): Rgba {
        val reflectance = listOf(base.red, base.green, base.blue).map { DIELECTRIC * (1f - metallic) + it * metallic }
        val strength = (shininess + 2) / 8f * (1f - roughness)
        val most = 1f / maxOf(reflectance.max(), DIELECTRIC)
        return Rgba(reflectance[0], reflectance[1], reflectance[2]).scaled(minOf(strength, most))
    }

    private fun emission(json: MaterialJson): Rgba {
        val color = color(json.emissiveFactor, Rgba.BLACK)
        val strength = json.extension("KHR_materials_emissive_strength") ?: return color
        return color.scaled(ExtensionValues.number(strength, "emissiveStrength", 1.0).toFloat())
    }

    private fun color(factors: FloatArray?, missing: Rgba): Rgba =
        if (factors == null) missing else Rgba(factors[0], factors[1], factors[2], factors.getOrElse(3) { 1f })

    private companion object {
        /** Reflectance of dielectrics such as glass and plastic, appendix B.2. */
        const val DIELECTRIC = 0.04f
    }
}

/**
 * The maps of one material, and the sets of texture coordinates that they use, in the order of their first use. A mesh
 * has two sets; a map with a third one is left out.
 */
internal class GltfMaps(private val document: GltfDocument, private val textures: GltfTextures) {
    private val sets = ArrayList<Int>()

    /** The numbers of the sets, as in `TEXCOORD_0`: at most two, and 0 if there are no maps. */
    val texCoordSets: List<Int> get() = sets.ifEmpty { listOf(0) }

    /** Returns the map that [info] describes, or null if there is none. [where] is its place in the file. */
    fun map(info: TextureInfoJson?, encoding: Texture.Encoding, where: String): TextureMap? {
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
