package dev.lazyz.scenes.images

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Texture
import java.io.ByteArrayInputStream
import java.io.IOException
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.imageio.stream.MemoryCacheImageInputStream

/**
 * Textures from image files: PNG, JPEG, and what else the JDK reads (BMP, GIF).
 *
 * Texels are the file's own codes, see [Texels]; profiles are passed over. A JPEG's codes are what the JDK's decoder
 * makes of it, which need not be the same on every JDK.
 */
internal object TextureFiles {
    /** What a warning says of a picture that is there and cannot be read. */
    const val NOT_DECODED: String = "cannot be decoded and is left out; save it as PNG or JPEG"

    /** An array cannot be longer. */
    private const val MAX_TEXELS = Int.MAX_VALUE - 8L

    /**
     * Most texels a byte of a file can stand for. Compression ends near 1032:1 for PNG (RFC 1951), 8 texels of 1 bit a
     * byte; a header that promises more is a trap, and a picture of it would fill memory before it failed.
     */
    private const val MAX_TEXELS_PER_BYTE = 16384L

    /**
     * Returns the picture in [bytes], which [source] holds or refers to, as a texture called [name]; null if it cannot be
     * decoded.
     */
    fun decode(source: Source, bytes: ByteArray, name: String): Texture? = try {
        read(source, JpegProfile.remove(bytes), name)
    } catch (tooLarge: SceneFormatException) {
        throw tooLarge
    } catch (_: IOException) {
        null
    } catch (_: RuntimeException) {
        // A damaged file makes some of the JDK's decoders fail at an index or a negative size
        null
    } catch (_: LinkageError) {
        // A JDK cut down to run without java.desktop
        null
    }

    /**
     * Returns the texture in the file that [reference] stands for, looked for in [folders]; null, with a warning, if there
     * is no such file or it cannot be decoded. A file is decoded once, however it is spelt.
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
                Texture(width, height, Texels.of(reader.read(0)), name = name)
            } finally {
                reader.dispose()
            }
        }
}
