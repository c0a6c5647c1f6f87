package dev.lazyz.scenes.images

import dev.lazyz.Texture
import dev.lazyz.scenes.Source
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
    /** Most texels of a texture: 16384 x 16384, a gigabyte. */
    private const val MAX_TEXELS = 1L shl 28

    /**
     * Most texels a byte of a file can stand for. Compression ends near 1032:1 for PNG (RFC 1951), 8 texels of 1 bit a
     * byte; a header that promises more is a trap, and a picture of it would fill memory before it failed.
     */
    private const val MAX_TEXELS_PER_BYTE = 16384L

    /** Returns the picture in [bytes] as a texture called [name], or null if it cannot be decoded. */
    fun decode(bytes: ByteArray, name: String): Texture? = try {
        read(JpegProfile.remove(bytes), name)
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
     * Returns the texture in the file that [reference] stands for, see [FileReferences]; null, with a warning, if the
     * file is missing or cannot be decoded.
     */
    fun find(source: Source, reference: String): Texture? = find(source, listOfNotNull(source.folder), reference)

    /** As the other, but looks through [folders] in order. */
    fun find(source: Source, folders: List<Path>, reference: String): Texture? {
        if (folders.isEmpty()) {
            source.warn("texture $reference is left out, for a stream has no folder; load from a file instead")
            return null
        }
        val file = folders.firstNotNullOfOrNull { FileReferences.find(it, reference) }
        if (file == null) {
            source.warn("texture $reference is missing and left out; put it into ${folders.last()}")
            return null
        }
        val texture = FileReferences.read(file)?.let { decode(it, file.fileName.toString()) }
        if (texture == null) source.warn("texture $reference cannot be decoded and is left out; save it as PNG or JPEG")
        return texture
    }

    private fun read(bytes: ByteArray, name: String): Texture? =
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
                Texture(width, height, Texels.of(reader.read(0)), name = name)
            } finally {
                reader.dispose()
            }
        }
}
