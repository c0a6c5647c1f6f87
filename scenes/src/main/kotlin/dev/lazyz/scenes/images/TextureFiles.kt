package dev.lazyz.scenes.images

import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.file.Path

/**
 * Reads textures from image files: PNG, JPEG, TGA, and the other formats that the JDK reads (TIFF, BMP, GIF, WBMP).
 *
 * Texels are the codes that the file stores, see [Texels]; colour profiles are ignored. The codes of a JPEG are those
 * that the JDK's decoder computes, which can differ between JDKs. Textures have the filter [MipFilter.ANISOTROPIC].
 */
internal object TextureFiles {
    /** The text of a warning about an image that exists but cannot be decoded. */
    const val NOT_DECODED: String = "cannot be decoded and is left out; save it as PNG or JPEG"

    /**
     * Returns the image in [bytes], which [source] contains or refers to, as a texture called [name]; null if it
     * cannot be decoded.
     */
    fun decode(source: Source, bytes: ByteArray, name: String): Texture? =
        ImageDecoder.decode(
            bytes, admit = { source.loading.texels(source, it) }, look = { source.loading.look(source.name) },
        ) { image ->
            val texels = Texels.of(image) { source.step(image.width) }
            Texture(image.width, image.height, texels, name = name, mipFilter = MipFilter.ANISOTROPIC)
        }

    /**
     * Returns the texture in the file that [reference] names, searched for in [folders]; null, with a warning, if
     * there is no such file or it cannot be decoded. A file is decoded only once, even if its references are spelt
     * differently.
     */
    fun find(source: Source, reference: String, folders: List<Path> = listOfNotNull(source.folder)): Texture? {
        val found = source.references.find(reference, folders)
        if (found.file == null) {
            source.warn("texture ", reference, " ${found.warning}")
            return null
        }
        val texture = ofFile(source, found.file)
        if (texture == null) source.warn("texture ", reference, " $NOT_DECODED")
        return texture
    }

    /** Returns the texture in [file], or null if it cannot be read or decoded. */
    fun ofFile(source: Source, file: Path): Texture? {
        val textures = source.loading.textures
        val key = file.toRealPath()
        if (key !in textures) {
            val bytes = FileReferences.read(file)
            bytes?.let { source.loading.read(it.size) }
            textures[key] = bytes?.let { decode(source, it, file.fileName.toString()) }
        }
        return textures[key]
    }
}
