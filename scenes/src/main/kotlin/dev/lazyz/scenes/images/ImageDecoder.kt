package dev.lazyz.scenes.images

import dev.lazyz.scenes.SceneFormatException
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.IOException
import javax.imageio.ImageIO
import javax.imageio.stream.MemoryCacheImageInputStream

/**
 * Decodes image files with the readers of the JDK, PNG, JPEG, TIFF, BMP, GIF and WBMP, of several images the first; and
 * TGA.
 */
internal object ImageDecoder {
    /** The maximum length of an array. */
    private const val MAX_PIXELS = Int.MAX_VALUE - 8L

    /**
     * The maximum number of pixels per byte of a file. PNG compression reaches at most about 1032:1 (RFC 1951), with
     * 8 pixels of 1 bit per byte. A header that claims more is malicious or damaged, and decoding it would fill
     * memory before it failed.
     */
    private const val MAX_PIXELS_PER_BYTE = 16384L

    /**
     * Returns what [convert] makes of the image in [bytes], or null if it cannot be decoded.
     *
     * @param admit is given the number of pixels before they are decoded; throws [SceneFormatException] if they are
     *   too many
     */
    fun <T> decode(bytes: ByteArray, admit: (pixels: Long) -> Unit, convert: (BufferedImage) -> T): T? = try {
        read(JpegProfile.remove(bytes), admit, convert)
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

    private fun <T> read(bytes: ByteArray, admit: (pixels: Long) -> Unit, convert: (BufferedImage) -> T): T? =
        MemoryCacheImageInputStream(ByteArrayInputStream(bytes)).use { stream ->
            val readers = ImageIO.getImageReaders(stream)
            if (!readers.hasNext()) {
                return TgaImage.of(bytes)?.let {
                    admit(it.pixels)
                    convert(it.decode())
                }
            }
            val reader = readers.next()
            try {
                reader.setInput(stream, true)
                val pixels = reader.getWidth(0).toLong() * reader.getHeight(0)
                if (pixels > MAX_PIXELS || pixels > bytes.size * MAX_PIXELS_PER_BYTE) return null
                admit(pixels)
                convert(reader.read(0))
            } finally {
                reader.dispose()
            }
        }
}
