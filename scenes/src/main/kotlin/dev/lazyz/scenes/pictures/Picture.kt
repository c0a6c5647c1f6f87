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
         * Reads an image file: PNG, binary PPM, WebP, KTX2, TGA, TIFF, BMP, GIF, WBMP, or JPEG, whose pixels can differ
         * between JDKs. Of several images in a file, it reads the first.
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
            PpmDecoder.decode(bytes, name) ?: ImageDecoder.decode(bytes, admit = { _, _ -> }) { image ->
                if (Texels.isWide(image)) {
                    val argb = Texels.wide(image)
                    Picture(image.width, image.height) { argb[it] }
                } else {
                    ofArgb(image.width, image.height, Texels.of(image))
                }
            } ?: throw SceneFormatException(name, null, "it is no image that can be decoded", "save it as PNG")

        internal fun widened(argb: Int): Long {
            val alpha = (argb ushr 24 and 0xFF).toLong()
            val red = (argb ushr 16 and 0xFF).toLong()
            val green = (argb ushr 8 and 0xFF).toLong()
            val blue = (argb and 0xFF).toLong()
            return 257 * (alpha shl 48 or (red shl 32) or (green shl 16) or blue)
        }
    }
}

/**
 * Reads binary PPM files (`P6`) with 8 bits a channel, such as [dev.lazyz.scenes.writers.PpmSink] writes.
 *
 * Source: the Netpbm project, "PPM Format Specification".
 */
internal class PpmDecoder private constructor(private val bytes: ByteArray, private val name: String) {
    private var next = MAGIC.length

    private fun picture(): Picture {
        val width = number("width", MOST_SIDE)
        val height = number("height", MOST_SIDE)
        val most = number("maximum", UShort.MAX_VALUE.toInt())
        if (most != BYTE_MAX) {
            fail("its maximum is $most, and only $BYTE_MAX can be read", "save it with 8 bits a channel")
        }

        // One white space character is between the header and the pixels
        next++
        val missing = 3L * width * height - (bytes.size - next)
        if (missing > 0) fail("it ends $missing bytes before its last pixel", "check that it was written completely")
        val start = next
        return Picture.ofArgb(width, height, IntArray(width * height) { OPAQUE or rgb(start + 3 * it) })
    }

    private fun rgb(at: Int): Int =
        bytes[at].toInt() and 0xFF shl 16 or (bytes[at + 1].toInt() and 0xFF shl 8) or (bytes[at + 2].toInt() and 0xFF)

    private fun number(what: String, most: Int): Int {
        skipSpace()
        var value = 0L
        val first = next
        while (next < bytes.size && bytes[next] in DIGITS && value <= most) value = 10 * value + (bytes[next++] - ZERO)
        if (next == first || value !in 1..most) fail("its $what is not in 1..$most", "check that it is a PPM file")
        return value.toInt()
    }

    /** Skips white space and comments, from `#` to the end of the line. */
    private fun skipSpace() {
        while (next < bytes.size) {
            val char = bytes[next].toInt().toChar()
            if (char == '#') {
                while (next < bytes.size && bytes[next] != LINE_END) next++
            } else if (!char.isWhitespace()) {
                return
            }
            next++
        }
    }

    private fun fail(problem: String, remedy: String): Nothing = throw SceneFormatException(name, null, problem, remedy)

    companion object {
        private const val MAGIC = "P6"
        private const val BYTE_MAX = 255
        private const val MOST_SIDE = 1 shl 24
        private const val OPAQUE = 0xFF shl 24
        private const val ZERO = '0'.code.toByte()
        private const val LINE_END = '\n'.code.toByte()
        private val DIGITS = ZERO..'9'.code.toByte()

        /**
         * Returns the picture of [bytes], or null if they do not begin like a PPM file.
         *
         * @throws SceneFormatException if the file is damaged, or has more than 8 bits a channel
         */
        fun decode(bytes: ByteArray, name: String): Picture? {
            val isPpm = bytes.size > MAGIC.length && MAGIC.indices.all { bytes[it] == MAGIC[it].code.toByte() }
            return if (isPpm) PpmDecoder(bytes, name).picture() else null
        }
    }
}
