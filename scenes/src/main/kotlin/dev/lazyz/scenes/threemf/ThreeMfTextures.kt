package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureWrap

/** The textures of a package, each decoded once. Not thread safe. */
internal class ThreeMfTextures(private val source: Source, private val archive: ThreeMfPackage) {
    private val decoded = HashMap<String, Texture?>()

    /**
     * Returns the texture described by [texture]. Returns null, with a warning, if it is missing or cannot be decoded.
     */
    fun find(texture: ThreeMfTexture): Texture? {
        val picture = decoded.getOrPut(texture.path) { decode(texture.path) } ?: return null
        val filter = if (texture.isSmooth) TextureFilter.BILINEAR else TextureFilter.NEAREST
        return picture.withSampling(filter, wrap(texture.wrapU), wrap(texture.wrapV))
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
