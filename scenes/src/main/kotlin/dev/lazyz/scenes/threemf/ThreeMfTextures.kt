package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.ChannelPacking
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureWrap

/** The textures of a package, each decoded once. Not thread safe. */
internal class ThreeMfTextures(private val source: Source, private val archive: ThreeMfPackage) {
    private val decoded = HashMap<String, Texture?>()
    private val grounded = HashMap<Pair<String, Rgba>, Texture>()

    /**
     * Returns the texture described by [texture], on [ground] if that is not null. Returns null, with a warning, if it
     * is missing or cannot be decoded.
     */
    fun find(texture: ThreeMfTexture, ground: Rgba?): Texture? {
        if (texture.path !in decoded) decoded[texture.path] = decode(texture.path)
        val own = decoded[texture.path] ?: return null
        val picture = if (ground == null || !own.hasAlpha) own else grounded(texture.path, own, ground)
        val filter = if (texture.isSmooth) TextureFilter.BILINEAR else TextureFilter.NEAREST
        return picture.withSampling(filter, wrap(texture.wrapU), wrap(texture.wrapV))
    }

    private fun grounded(path: String, picture: Texture, ground: Rgba): Texture =
        grounded.getOrPut(Pair(path, ground)) {
            source.loading.texels(source, picture.width.toLong() * picture.height)
            ChannelPacking.onColor(picture, ground)
        }

    private fun decode(path: String): Texture? {
        val bytes = archive.bytes(path)
        val texture = bytes?.let { TextureFiles.decode(source, it, path.substringAfterLast('/')) }
        if (bytes == null) source.warn("texture $path is not in the package and is left out")
        if (bytes != null && texture == null) source.warn("texture $path ${TextureFiles.NOT_DECODED}")
        return texture
    }

    private fun wrap(style: String?): TextureWrap = when (style) {
        "mirror" -> TextureWrap.MIRROR
        "clamp", "none" -> TextureWrap.CLAMP
        else -> TextureWrap.REPEAT
    }
}
