package dev.lazyz.scenes.obj

import de.javagl.obj.FloatTuple
import de.javagl.obj.Mtl
import dev.lazyz.Rgba
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Material
import dev.lazyz.world.Shading
import dev.lazyz.world.Texture
import dev.lazyz.world.TextureFilter
import dev.lazyz.world.TextureWrap
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
 * as `illum 2` defines it. `illum 0` means no lighting, and `illum 1` no highlight. `d` below 1 makes a translucent
 * material. So does `Tr`, which is 1 - `d`, except that `Tr 1` without a `d` is treated as opaque, because some
 * programs write it for opaque materials. The alpha of a texture is used only if `map_d` names the same file, and then
 * as a mask.
 *
 * @param folders folders to search for textures, in order
 */
internal class MtlMaterials(private val source: Source, private val folders: List<Path>) {
    private val textures = HashMap<String, Texture?>()

    /**
     * Returns the material of [mtl] with the texture statements [maps]. [hasOpacity] is true if the entry has a `d`. A
     * mask that is not used is added to [unused].
     */
    fun material(mtl: Mtl, maps: Map<String, MtlMap>, hasOpacity: Boolean, unused: KindCounts): MtlMaterial {
        val map = maps["map_kd"]
        val texture = map?.let(::texture)
        val mask = maps["map_d"]
        val isMasked = texture != null && mask?.file == map.file
        if (mask != null && !isMasked) unused.add("map_d")

        val alpha = alpha(mtl, hasOpacity)
        val isLit = mtl.illum != 0
        val material = Material(
            baseColor = baseColor(mtl, map != null).withAlpha(alpha),
            texture = texture,
            shading = if (isLit) Shading.BLINN_PHONG else Shading.CONSTANT,
            specular = if (mtl.illum in listOf(0, 1)) Rgba.BLACK else color(mtl.ks) ?: Rgba.BLACK,
            shininess =
            mtl.ns?.takeIf { it.isFinite() }?.let { (it + 0.5f).toInt().coerceIn(1, 1024) } ?: DEFAULT_SHININESS,
            emission = color(mtl.ke) ?: Rgba.BLACK,
            alphaMode = if (alpha < 1f) {
                AlphaMode.BLEND
            } else if (isMasked) {
                AlphaMode.MASK
            } else {
                AlphaMode.OPAQUE
            },
            name = mtl.name,
        )
        return if (map == null) MtlMaterial(material) else placed(material, map)
    }

    private fun alpha(mtl: Mtl, hasOpacity: Boolean): Float {
        val alpha = mtl.d?.takeIf { it.isFinite() }?.coerceIn(0f, 1f) ?: 1f
        if (alpha > 0f || hasOpacity) return alpha
        source.warn("material ${mtl.name}: Tr 1 without d is treated as opaque; to make it invisible, write d 0")
        return 1f
    }

    private fun placed(material: Material, map: MtlMap) =
        MtlMaterial(material, map.scale[0], map.scale[1], map.offset[0], map.offset[1])

    private fun baseColor(mtl: Mtl, hasMap: Boolean): Rgba {
        val color = color(mtl.kd) ?: return Rgba.WHITE
        return if (hasMap && color == Rgba.BLACK) Rgba.WHITE else color
    }

    private fun color(tuple: FloatTuple?): Rgba? = tuple?.let {
        Rgba(
            SrgbDecoding.decode(it.x.toDouble()),
            SrgbDecoding.decode(it.y.toDouble()),
            SrgbDecoding.decode(it.z.toDouble()),
        )
    }

    private fun texture(map: MtlMap): Texture? {
        val texture = textures.getOrPut(map.file) { TextureFiles.find(source, map.file, folders) }
        if (!map.isClamped) return texture
        return texture?.withSampling(TextureFilter.BILINEAR, TextureWrap.CLAMP, TextureWrap.CLAMP)
    }

    private companion object {
        const val DEFAULT_SHININESS = 32
    }
}
