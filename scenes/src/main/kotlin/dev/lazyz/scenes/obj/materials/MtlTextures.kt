package dev.lazyz.scenes.obj.materials

import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.HeightNormals
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.material.NormalMap
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import java.nio.file.Path

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
