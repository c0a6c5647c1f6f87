package dev.lazyz.scenes.pictures

import dev.lazyz.Image
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.images.ImageDecoder
import dev.lazyz.scenes.images.Texels
import java.io.IOException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * The colours of a picture, as a file stores them or as they were rendered.
 *
 * A pixel has four channels of 16 bits with straight alpha. A channel that is stored with fewer bits is scaled; 8 bits
 * are multiplied by 257, so `0x80` is `0x8080`. Pictures are the same if their pixels are, whatever their files are: a
 * grey PNG can be the same as one in colours, and one without alpha the same as one that is opaque. There is no colour
 * management: profiles and gamma of a file are ignored.
 *
 * Immutable and thread safe. Memory: 4 bytes a pixel; 8 bytes if a file has more than 8 bits a channel; nothing more
 * than the image for a picture [of] an image.
 *
 * @property width number of columns
 * @property height number of rows
 */
public class Picture private constructor(public val width: Int, public val height: Int, private val pixels: Pixels) {
    /**
     * Returns the pixel at column [x] and row [y], 16 bits a channel, `0xAAAARRRRGGGGBBBB`.
     *
     * @throws IllegalArgumentException if there is no such pixel
     */
    public fun argb(x: Int, y: Int): Long {
        require(x in 0 until width && y in 0 until height) { "pixel must be within $width x $height: ($x, $y)" }
        return pixels.argb(y * width + x)
    }

    /**
     * Returns the colour at column [x] and row [y] as text: `#rrggbbaa`, or `#rrrrggggbbbbaaaa` if 8 bits a channel
     * are not enough for it.
     *
     * @throws IllegalArgumentException if there is no such pixel
     */
    public fun color(x: Int, y: Int): String {
        val argb = argb(x, y)
        val channels = listOf(32, 16, 0, 48).map { (argb ushr it and 0xFFFF).toInt() }
        val isByte = channels.all { it % 257 == 0 }
        return channels.joinToString("", "#") { if (isByte) "%02x".format(it / 257) else "%04x".format(it) }
    }

    override fun toString(): String = "Picture($width x $height)"

    /** The pixel at an index, in rows from the top, as [Picture.argb] returns it. */
    private fun interface Pixels {
        fun argb(index: Int): Long
    }

    public companion object {
        /** Returns the colours of [image], without copying them. */
        @JvmStatic
        public fun of(image: Image): Picture = ofArgb(image.width, image.height, image.argb)

        /**
         * Returns a picture of [width] x [height] colours in rows from the top, `0xAARRGGBB`. The array is not copied;
         * do not change it.
         *
         * @throws IllegalArgumentException if the array does not have one element for each pixel
         */
        @JvmStatic
        public fun ofArgb(width: Int, height: Int, argb: IntArray): Picture {
            require(width > 0 && height > 0 && argb.size.toLong() == width.toLong() * height) {
                "a picture of $width x $height needs one colour for each pixel: ${argb.size}"
            }
            return Picture(width, height) { widened(argb[it]) }
        }

        /**
         * Reads an image file: PNG, binary PPM, TGA, TIFF, BMP, GIF, WBMP, or JPEG, whose pixels can differ between
         * JDKs. Of several images in a file, it reads the first.
         *
         * @throws SceneReadException if the file is missing or unreadable
         * @throws SceneFormatException if it is no image
         */
        @JvmStatic
        @Throws(SceneFormatException::class)
        public fun read(path: Path): Picture {
            val bytes = try {
                Files.readAllBytes(path)
            } catch (missing: NoSuchFileException) {
                throw SceneReadException("$path", "there is no such file", cause = missing)
            } catch (failure: IOException) {
                val reason = if (Files.isDirectory(path)) "it is a folder" else "it cannot be read"
                throw SceneReadException("$path", reason, "name an image file", failure)
            }
            return decode(bytes, "$path")
        }

        /**
         * Decodes the bytes of an image file, see [read].
         *
         * @param name name of the picture in messages
         * @throws SceneFormatException if the bytes are no image
         */
        @JvmStatic
        @JvmOverloads
        @Throws(SceneFormatException::class)
        public fun decode(bytes: ByteArray, name: String = "<bytes>"): Picture =
            PpmDecoder.decode(bytes, name) ?: ImageDecoder.decode(bytes, admit = {}) { image ->
                if (Texels.isWide(image)) {
                    val argb = Texels.wide(image)
                    Picture(image.width, image.height) { argb[it] }
                } else {
                    ofArgb(image.width, image.height, Texels.of(image))
                }
            } ?: throw SceneFormatException(name, null, "it is no image that can be decoded", "save it as PNG")

        private fun widened(argb: Int): Long {
            val alpha = (argb ushr 24 and 0xFF).toLong()
            val red = (argb ushr 16 and 0xFF).toLong()
            val green = (argb ushr 8 and 0xFF).toLong()
            val blue = (argb and 0xFF).toLong()
            return 257 * (alpha shl 48 or (red shl 32) or (green shl 16) or blue)
        }
    }
}
