package dev.lazyz.scenes.obj.materials

import de.javagl.obj.FloatTuple
import de.javagl.obj.Mtl
import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import java.nio.file.Path

/**
 * A material as defined in a library.
 *
 * @property material the material
 * @property scaleU factor of u (v points upward), applied before the offset
 * @property scaleV factor of v, applied before the offset
 * @property offsetU offset of u
 * @property offsetV offset of v
 * @property isDefined whether a library defines the material
 */
internal class MtlMaterial(
    val material: Material,
    val scaleU: Double = 1.0,
    val scaleV: Double = 1.0,
    val offsetU: Double = 0.0,
    val offsetV: Double = 0.0,
    val isDefined: Boolean = true,
)

/**
 * Converts the entries of one material library to materials.
 *
 * Authors of libraries choose numbers by their appearance on a screen, so `Kd`, `Ks` and `Ke` are sRGB-encoded. `Kd`
 * multiplies the texture, except that a black `Kd` with a `map_Kd` is treated as white: programs that write it mean the
 * unchanged texture, and black would make it invisible. The highlight is `Ks` by the halfway vector with exponent `Ns`,
 * as `illum 2` defines it. `illum 0` means no lighting, and `illum 1` no highlight, as does `Ns 0`: a highlight with
 * this exponent would be equally bright everywhere, and programs write it for materials that are not glossy. `d` below
 * 1 makes a translucent material. So does `Tr`, which is 1 - `d`. `d 0`, or `Tr 1` without a `d`, is treated as opaque,
 * with a warning, because some programs write it for opaque materials. The alpha of a texture is used only if `map_d`
 * names the same file, and then as a mask. Another file of `map_d` is a mask, too: its alpha, or its grey if it has
 * none, placed like `map_Kd`.
 *
 * `norm` is a normal map, and `bump` or `map_bump` an image of heights, see [HeightNormals]; `map_Ke` multiplies `Ke`,
 * or white if `Ke` is black or missing. A material with `Pm`, `Pr`, `map_Pm` or `map_Pr` (C. Hery et al., the extension
 * of MTL for physically based rendering, 2013) is a metallic-roughness material; so is one with a clear coat, `Pc` with
 * the roughness `Pcr`, sheen, `Ps`, or anisotropy, `aniso` with the part `anisor` of a full turn. A map replaces its
 * number. Without both, a material is no metal, and its roughness is `(2 / (Ns + 2))^(1/4)`.
 *
 * @param folders folders to search for textures, in order
 */
internal class MtlMaterials(private val source: Source, folders: List<Path>) {
    private val textures = MtlTextures(source, folders)

    /**
     * Returns the material of [mtl] with the texture statements [maps] and the numbers [model], such as
     * `pm`.
     * [hasOpacity] is true if the entry has a `d`.
     */
    fun material(mtl: Mtl, maps: Map<String, MtlMap>, hasOpacity: Boolean, model: Map<String, Float>): MtlMaterial {
        val map = maps["map_kd"]
        val mask = maps["map_d"]
        val own = map?.let(textures::texture)
        val isOwnMask = own != null && mask?.file == map.file
        val texture = if (mask == null || isOwnMask) own else textures.withOpacity(map, mask)
        val isMasked = isOwnMask || (mask != null && texture !== own)

        val alpha = alpha(mtl, hasOpacity)
        val isLit = mtl.illum != 0
        val material = Material(
            baseColor = baseColor(mtl, map != null).withAlpha(alpha),
            texture = texture,
            shading = if (isLit) Shading.BLINN_PHONG else Shading.CONSTANT,
            specular = specular(mtl),
            shininess =
            mtl.ns?.takeIf { it.isFinite() }?.let { (it + 0.5f).toInt().coerceIn(1, 1024) } ?: DEFAULT_SHININESS,
            emission = emission(mtl, maps["map_ke"] != null),
            alphaMode = if (alpha < 1f) {
                AlphaMode.BLEND
            } else if (isMasked) {
                AlphaMode.MASK
            } else {
                AlphaMode.OPAQUE
            },
            name = mtl.name,
        ).withMetallicRoughness(model(mtl, maps, model))
            .withNormalMap(textures.normalMap(maps["norm"], maps["map_bump"] ?: maps["bump"], map))
            .withEmissionMap(textures.map(maps["map_ke"], map))
        return if (map == null) MtlMaterial(material) else placed(material, map)
    }

    private fun alpha(mtl: Mtl, hasOpacity: Boolean): Float {
        val alpha = mtl.d?.takeIf { it.isFinite() }?.coerceIn(0f, 1f) ?: 1f
        if (alpha > 0f) return alpha
        val statement = if (hasOpacity) "d 0" else "Tr 1 without d"
        source.warn("material ", mtl.name, ": $statement would make it invisible, and is treated as opaque")
        return 1f
    }

    private fun placed(material: Material, map: MtlMap) =
        MtlMaterial(material, map.scale[0], map.scale[1], map.offset[0], map.offset[1])

    private fun baseColor(mtl: Mtl, hasMap: Boolean): Rgba {
        val color = color(mtl.kd) ?: return Rgba.WHITE
        return if (hasMap && color == Rgba.BLACK) Rgba.WHITE else color
    }

    private fun specular(mtl: Mtl): Rgba {
        val exponent = mtl.ns?.takeIf { it.isFinite() } ?: DEFAULT_SHININESS.toFloat()
        return if (mtl.illum in listOf(0, 1) || exponent <= 0f) Rgba.BLACK else color(mtl.ks) ?: Rgba.BLACK
    }

    private fun color(tuple: FloatTuple?): Rgba? = tuple?.let {
        Rgba(Rgba.linearOf(it.x.toDouble()), Rgba.linearOf(it.y.toDouble()), Rgba.linearOf(it.z.toDouble()))
    }

    private fun emission(mtl: Mtl, hasMap: Boolean): Rgba {
        val color = color(mtl.ke) ?: Rgba.BLACK
        return if (hasMap && color == Rgba.BLACK) Rgba.WHITE else color
    }

    private fun model(mtl: Mtl, maps: Map<String, MtlMap>, numbers: Map<String, Float>): MetallicRoughness? {
        val roughnessMap = maps["map_pr"]
        val metallicMap = maps["map_pm"]
        val lobes = lobes(numbers)
        val isClassical = lobes == null && "pm" !in numbers && "pr" !in numbers
        if (isClassical && roughnessMap == null && metallicMap == null) return null
        val exponent = mtl.ns?.takeIf { it.isFinite() && it >= 0f } ?: DEFAULT_SHININESS.toFloat()
        val ofHighlight = StrictMath.sqrt(StrictMath.sqrt(2.0 / (exponent + 2.0))).toFloat()
        val roughness = if (roughnessMap != null) 1f else numbers["pr"] ?: ofHighlight
        val metallic = if (metallicMap != null) 1f else numbers["pm"] ?: 0f
        return MetallicRoughness(metallic, roughness, textures.model(roughnessMap, metallicMap, maps["map_kd"]), lobes)
    }

    private fun lobes(numbers: Map<String, Float>): Lobes? {
        val coat = numbers["pc"]?.takeIf { it > 0f }?.let { Lobes.Clearcoat(it, numbers["pcr"] ?: 0f) }
        val sheen = numbers["ps"]?.takeIf { it > 0f }?.let { Lobes.Sheen(Rgba(it, it, it), SHEEN_ROUGHNESS) }
        val anisotropy =
            numbers["aniso"]?.takeIf { it > 0f }?.let { Lobes.Anisotropy(it, 360f * (numbers["anisor"] ?: 0f)) }
        return Lobes(sheen = sheen, clearcoat = coat, anisotropy = anisotropy).takeIf { it != Lobes() }
    }

    private companion object {
        const val DEFAULT_SHININESS = 32

        /** MTL has no word for it. */
        const val SHEEN_ROUGHNESS = 0.5f
    }
}
