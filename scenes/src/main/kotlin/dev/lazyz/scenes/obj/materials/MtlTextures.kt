package dev.lazyz.scenes.obj.materials

import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.images.code
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import java.nio.file.Path
import kotlin.math.sqrt

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
