package dev.lazyz.scenes.images

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.MipFilter
import dev.lazyz.world.Texture
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.imageio.stream.MemoryCacheImageInputStream

/**
 * Reads textures from image files: PNG, JPEG, and the other formats that the JDK reads (BMP, GIF).
 *
 * Texels are the codes that the file stores, see [Texels]; colour profiles are ignored. The codes of a JPEG are those
 * that the JDK's decoder computes, which can differ between JDKs. Textures have the filter [MipFilter.ANISOTROPIC].
 */
internal object TextureFiles {
    /** The text of a warning about an image that exists but cannot be decoded. */
    const val NOT_DECODED: String = "cannot be decoded and is left out; save it as PNG or JPEG"

    /** The maximum length of an array. */
    private const val MAX_TEXELS = Int.MAX_VALUE - 8L

    /**
     * The maximum number of texels per byte of a file. PNG compression reaches at most about 1032:1 (RFC 1951), with
     * 8 texels of 1 bit per byte. A header that claims more is malicious or damaged, and decoding it would fill
     * memory before it failed.
     */
    private const val MAX_TEXELS_PER_BYTE = 16384L

    /**
     * Returns the image in [bytes], which [source] contains or refers to, as a texture called [name]; null if it
     * cannot be decoded.
     */
    fun decode(source: Source, bytes: ByteArray, name: String): Texture? = try {
        read(source, JpegProfile.remove(bytes), name)
    } catch (tooLarge: SceneFormatException) {
        throw tooLarge
    } catch (_: IOException) {
        null
    } catch (_: RuntimeException) {
        // Some decoders of the JDK fail on a damaged file with an index out of bounds or a negative size
        null
    } catch (_: LinkageError) {
        // A reduced JDK without java.desktop
        null
    }

    /**
     * Returns the texture in the file that [reference] names, searched for in [folders]; null, with a warning, if
     * there is no such file or it cannot be decoded. A file is decoded only once, even if its references are spelt
     * differently.
     */
    fun find(source: Source, reference: String, folders: List<Path> = listOfNotNull(source.folder)): Texture? {
        val found = source.references.find(reference, folders)
        if (found.file == null) {
            source.warn("texture $reference ${found.warning}")
            return null
        }
        val texture = ofFile(source, found.file)
        if (texture == null) source.warn("texture $reference $NOT_DECODED")
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

    private fun read(source: Source, bytes: ByteArray, name: String): Texture? =
        MemoryCacheImageInputStream(ByteArrayInputStream(bytes)).use { stream ->
            val readers = ImageIO.getImageReaders(stream)
            if (!readers.hasNext()) return null
            val reader = readers.next()
            try {
                reader.setInput(stream, true)
                val width = reader.getWidth(0)
                val height = reader.getHeight(0)
                val texels = width.toLong() * height
                if (texels > MAX_TEXELS || texels > bytes.size * MAX_TEXELS_PER_BYTE) return null
                source.loading.texels(source, texels)
                Texture(width, height, Texels.of(reader.read(0)), name = name, mipFilter = MipFilter.ANISOTROPIC)
            } finally {
                reader.dispose()
            }
        }
}
