package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform

/** The textures of a package, each decoded once. Not thread safe. */
internal class ThreeMfTextures(private val source: Source, private val archive: ThreeMfPackage) {
    private val decoded = HashMap<String, Texture?>()
    private val made = HashMap<Any, Texture>()

    /**
     * Returns the texture described by [texture], on [ground] if that is not null. Beyond its border, it has the colour
     * [outside] in the directions of tile style `none`. Returns null, with a warning, if it is missing or cannot be
     * decoded.
     */
    fun find(texture: ThreeMfTexture, ground: Rgba?, outside: Rgba): TextureMap? {
        val own = picture(texture) ?: return null
        return laid(texture, if (ground == null || !own.hasAlpha) own else grounded(texture.path, own, ground), outside)
    }

    /** Returns the map of roughness and metalness from their textures, laid as [texture]; null if there are none. */
    fun metallicRoughness(
        texture: ThreeMfTexture,
        metallic: ThreeMfTexture?,
        roughness: ThreeMfTexture?,
    ): TextureMap? = numbers(texture, roughness, metallic) { first, second ->
        val isSame = metallic?.path == roughness?.path
        ChannelPacking.metallicRoughness(first, second, { red(it) }, { if (isSame) green(it) else red(it) })
    }

    /** Returns the map of roughness from the texture [gloss] times [factor]; null if there is none. */
    fun roughness(
        texture: ThreeMfTexture,
        specular: ThreeMfTexture?,
        gloss: ThreeMfTexture?,
        factor: Float,
    ): TextureMap? = numbers(texture, gloss, null, factor) { first, _ ->
        val isSame = specular?.path == gloss?.path
        ChannelPacking.metallicRoughness(first, null, { texel ->
            0xFF - (factor * (if (isSame) texel ushr 24 else red(texel)) + 0.5f).toInt()
        })
    }

    /** Returns the map of specular colours, laid as [texture]; null if there is none. */
    fun specularColors(texture: ThreeMfTexture, specular: ThreeMfTexture?): TextureMap? =
        specular?.let(::picture)?.let { laid(texture, it, ThreeMfFinish.PLASTIC) }

    private fun numbers(
        texture: ThreeMfTexture,
        first: ThreeMfTexture?,
        second: ThreeMfTexture?,
        factor: Float = 1f,
        pack: (Texture?, Texture?) -> Texture?,
    ): TextureMap? {
        val pictures = listOf(first?.let(::picture), second?.let(::picture))
        val packed = made.getOrPut(listOf(pictures, first?.path, second?.path, factor)) {
            val most = pictures.maxOf { if (it == null) 0 else it.width.toLong() * it.height }
            source.loading.texels(source, most)
            pack(pictures[0], pictures[1]) ?: return null
        }
        return laid(texture, packed, MATT)
    }

    private fun picture(texture: ThreeMfTexture): Texture? {
        if (texture.path !in decoded) decoded[texture.path] = decode(texture.path)
        return decoded[texture.path]
    }

    private fun red(texel: Int) = texel ushr 16 and 0xFF

    private fun green(texel: Int) = texel ushr 8 and 0xFF

    /** Returns [picture] laid as [texture] says. */
    private fun laid(texture: ThreeMfTexture, picture: Texture, outside: Rgba): TextureMap {
        val width = size(picture.width, texture.wrapU)
        val height = size(picture.height, texture.wrapV)
        val framed = framed(picture, width, height, outside)
        val filter = if (texture.isSmooth) Texture.Filter.BILINEAR else Texture.Filter.NEAREST
        return TextureMap(
            framed.withSampling(filter, wrap(texture.wrapU), wrap(texture.wrapV)),
            transform = UvTransform(
                picture.width.toDouble() / width, picture.height.toDouble() / height, 0.0,
                ((width - picture.width) / 2).toDouble() / width, ((height - picture.height) / 2).toDouble() / height,
            ),
        )
    }

    /**
     * Returns the size of an image of [size] with what is beyond its border: as much as the image, but two texels at
     * least.
     */
    private fun size(size: Int, style: String?): Long = if (style ==
        NONE
    ) {
        maxOf(2L * size, size + 2L)
    } else {
        size.toLong()
    }

    private fun framed(picture: Texture, width: Long, height: Long, outside: Rgba): Texture {
        if (width == picture.width.toLong() && height == picture.height.toLong()) return picture
        return made.getOrPut(listOf(picture, width, height, outside)) {
            source.loading.texels(source, width * height)
            if (width * height > Int.MAX_VALUE) {
                source.fail(null, "a texture of tile style none has too many pixels", "make it smaller")
            }
            ChannelPacking.framed(picture, width.toInt(), height.toInt(), outside)
        }
    }

    private fun grounded(path: String, picture: Texture, ground: Rgba): Texture =
        made.getOrPut(Pair(path, ground)) {
            source.loading.texels(source, picture.width.toLong() * picture.height)
            ChannelPacking.onColor(picture, ground)
        }

    private fun decode(path: String): Texture? {
        val bytes = archive.bytes(path)
        val texture = bytes?.let { TextureFiles.decode(source, it, path.substringAfterLast('/')) }
        if (bytes == null) source.warn("texture ", path, " is not in the package and is left out")
        if (bytes != null && texture == null) source.warn("texture ", path, " ${TextureFiles.notDecoded(bytes)}")
        return texture
    }

    private fun wrap(style: String?): Texture.Wrap = when (style) {
        "mirror" -> Texture.Wrap.MIRROR
        "clamp", NONE -> Texture.Wrap.CLAMP
        else -> Texture.Wrap.REPEAT
    }

    private companion object {
        /** Full roughness as green, and no metalness as blue. */
        val MATT = Rgba(1f, 1f, 0f)

        /** The tile style of textures that do not continue beyond their border. */
        const val NONE = "none"
    }
}
