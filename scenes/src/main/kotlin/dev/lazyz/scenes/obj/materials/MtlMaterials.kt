package dev.lazyz.scenes.obj.materials

import de.javagl.obj.FloatTuple
import de.javagl.obj.Mtl
import dev.lazyz.Rgba
import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.images.code
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import java.nio.file.Path
import kotlin.math.sqrt

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

/**
 * The textures of the materials of one library. Each image is read, and each combination of images is made, once.
 *
 * @param folders folders to search for textures, in order
 */
internal class MtlTextures(private val source: Source, private val folders: List<Path>) {
    private val textures = HashMap<String, Texture?>()
    private val made = HashMap<Any, Texture?>()

    /** Returns the image of [map], or null, with a warning, if there is none. */
    fun texture(map: MtlMap): Texture? {
        val texture = textures.getOrPut(map.file) { TextureFiles.find(source, name(map.file), folders) }
        if (!map.isClamped) return texture
        return made.getOrPut(listOf("clamped", map.file)) {
            texture?.withSampling(Texture.Filter.BILINEAR, Texture.Wrap.CLAMP, Texture.Wrap.CLAMP)
        }
    }

    /** Returns the name in [text], which may end with a comment, unless a file has all of it as its name. */
    private fun name(text: String): String {
        val name = TextLines.uncommented(text)
        return if (name == text || source.references.find(text, folders).file == null) name else text
    }

    /** Returns the image of [color], or white if it is null, with the image of [opacity] as alpha. */
    fun withOpacity(color: MtlMap?, opacity: MtlMap): Texture? {
        val mask = texture(opacity) ?: return color?.let(::texture)
        val own = color?.let(::texture)
        return made.getOrPut(listOf("opacity", own, mask)) { ChannelPacking.withOpacity(own, mask) }
    }

    /** Returns the map [map] with the coordinates of [base], which are applied to the mesh; or null. */
    fun map(map: MtlMap?, base: MtlMap?): TextureMap? =
        map?.let(::texture)?.let { TextureMap(it, transform = transform(map, base)) }

    /** Returns the maps of roughness and of metalness as one; or null. */
    fun model(roughness: MtlMap?, metallic: MtlMap?, base: MtlMap?): TextureMap? {
        val green = roughness?.let(::texture)
        val blue = metallic?.let(::texture)
        val packed = made.getOrPut(listOf("model", green, blue)) { ChannelPacking.metallicRoughness(green, blue) }
        return packed?.let { TextureMap(it, transform = transform(checkNotNull(roughness ?: metallic), base)) }
    }

    /** Returns the normal map [normals], or that of the heights [bump]; or null. */
    fun normalMap(normals: MtlMap?, bump: MtlMap?, base: MtlMap?): NormalMap? {
        val own = map(normals, base)
        if (own != null) return NormalMap(own.withTexture(linear(own.texture)))
        val heights = map(bump, base) ?: return null
        val factor = checkNotNull(bump).multiplier
        val texture = made.getOrPut(listOf("bump", heights.texture, factor)) {
            HeightNormals.of(heights.texture, factor)
        }
        return NormalMap(heights.withTexture(checkNotNull(texture)))
    }

    private fun linear(texture: Texture): Texture =
        checkNotNull(made.getOrPut(listOf("linear", texture)) { texture.withEncoding(Texture.Encoding.LINEAR) })

    /** Returns what leads from coordinates to which the options of [base] are applied to those of [map]; v downward. */
    private fun transform(map: MtlMap, base: MtlMap?): UvTransform {
        val scale = DoubleArray(2) { map.scale[it] / (base?.scale?.get(it) ?: 1.0) }
        val offset = DoubleArray(2) { map.offset[it] - (base?.offset?.get(it) ?: 0.0) * scale[it] }
        val down = 1.0 - scale[1] - offset[1]
        if (!(scale + offset).all { it.isFinite() }) return UvTransform.IDENTITY
        return UvTransform(scale[0], scale[1], 0.0, offset[0], down)
    }
}

/**
 * Converts a bump map, an image of heights, to a normal map.
 *
 * A height is the mean of red, green and blue, 0..1, times the factor, times [DEPTH] of the longer side of the image.
 * The slope at a texel is half the difference of its neighbours on both sides; beyond the border, the image continues
 * as the texture does.
 */
internal object HeightNormals {
    /** Depth of a full-range bump map, as a part of the longer side of the image. */
    private const val DEPTH = 1.0 / 128

    /** Returns the normals of the [heights] multiplied by [factor]: right, up and out as red, green and blue. */
    fun of(heights: Texture, factor: Double): Texture {
        val width = heights.width
        val height = heights.height
        val depth = factor * DEPTH * maxOf(width, height) / (3 * 255)
        val sums = IntArray(width * height) {
            val texel = heights.texel(it % width, it / width)
            (texel ushr 16 and 0xFF) + (texel ushr 8 and 0xFF) + (texel and 0xFF)
        }
        val normals = IntArray(width * height) {
            val x = it % width
            val row = it / width * width
            val left = sums[row + beside(x - 1, width, heights.wrapU)]
            val right = sums[row + beside(x + 1, width, heights.wrapU)]
            val above = sums[beside(it / width - 1, height, heights.wrapV) * width + x]
            val below = sums[beside(it / width + 1, height, heights.wrapV) * width + x]
            normal((left - right) * depth / 2, (below - above) * depth / 2)
        }
        return Texture(
            width, height, normals, heights.filter, heights.wrapU, heights.wrapV, heights.name, heights.mipFilter,
            Texture.Encoding.LINEAR,
        )
    }

    /** Returns the texel of the normal (x, y, 1), of unit length. */
    private fun normal(x: Double, y: Double): Int {
        val length = sqrt(x * x + y * y + 1.0)
        return 0xFF shl 24 or (code(x / length) shl 16) or (code(y / length) shl 8) or code(1.0 / length)
    }

    private fun code(component: Double): Int = ((component + 1.0) / 2 * 255 + 0.5).toInt()

    private fun beside(index: Int, size: Int, wrap: Texture.Wrap): Int = when {
        index in 0 until size -> index
        wrap == Texture.Wrap.REPEAT -> if (index < 0) size - 1 else 0
        else -> if (index < 0) 0 else size - 1
    }
}
