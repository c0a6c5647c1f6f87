package dev.lazyz

import java.security.MessageDigest

/**
 * A finished picture: for every sample a colour, a depth and the visible primitive.
 *
 * Two images are equal if all three are, bit for bit (contract rule 7.1). Immutable; the arrays returned are the
 * image's own and must not be changed.
 *
 * @property width number of columns
 * @property height number of rows
 * @property argb colours in rows from the top, 8-bit sRGB with straight alpha, `0xAARRGGBB`
 * @property depth depths in rows from the top, 0..2^31-1, see [Depth]
 * @property primitive submission index of the visible primitive, or [DepthTest.BACKGROUND], in rows from the top
 * @property counters what the rendering took
 */
public class Image(
    public val width: Int,
    public val height: Int,
    public val argb: IntArray,
    public val depth: IntArray,
    public val primitive: IntArray,
    public val counters: Counters,
) {
    init {
        val size = width.toLong() * height
        require(argb.size.toLong() == size && depth.size.toLong() == size && primitive.size.toLong() == size) {
            "an image of $width x $height needs $size samples: ${argb.size}, ${depth.size}, ${primitive.size}"
        }
    }

    /** Number of samples at which some primitive is visible. Cost: one pass over the samples. */
    public val visible: Int get() = primitive.count { it != DepthTest.BACKGROUND }

    /** Returns the colour at column [x] and row [y], `0xAARRGGBB`. */
    public fun argb(x: Int, y: Int): Int = argb[index(x, y)]

    /** Returns the depth at column [x] and row [y]. */
    public fun depth(x: Int, y: Int): Int = depth[index(x, y)]

    /** Returns the submission index of the primitive visible at column [x] and row [y], or [DepthTest.BACKGROUND]. */
    public fun primitive(x: Int, y: Int): Int = primitive[index(x, y)]

    /**
     * Returns the picture's identity: the SHA-256 of the colours, four bytes a sample in the order alpha, red, green,
     * blue, in rows from the top, as 64 hexadecimal digits. Width and height are not part of it.
     */
    public fun pixelHash(): String {
        val hash = PixelHash()
        val row = IntArray(width)
        for (y in 0 until height) {
            argb.copyInto(row, 0, y * width, (y + 1) * width)
            hash.add(row, width)
        }
        return hash.digest()
    }

    private fun index(x: Int, y: Int): Int {
        require(x in 0 until width && y in 0 until height) { "sample must be within $width x $height: ($x, $y)" }
        return y * width + x
    }

    override fun equals(other: Any?): Boolean = other is Image && width == other.width && height == other.height &&
        argb.contentEquals(other.argb) && depth.contentEquals(other.depth) && primitive.contentEquals(other.primitive)

    override fun hashCode(): Int = argb.contentHashCode() * 31 + depth.contentHashCode()

    override fun toString(): String = "Image($width x $height, $visible visible, ${pixelHash().take(12)})"

    /**
     * A sink that keeps all rows. Not thread safe.
     *
     * @throws IllegalArgumentException if the raster has more than 2^31-1 samples: stream its rows instead
     */
    public class Collector(private val raster: Raster) : RowSink {
        private val argb: IntArray
        private val depth: IntArray
        private val primitive: IntArray

        init {
            require(raster.size <= MAX_SAMPLES) {
                "an image in memory has at most $MAX_SAMPLES samples, stream the rows instead: ${raster.size}"
            }
            argb = IntArray(raster.size.toInt())
            depth = IntArray(raster.size.toInt())
            primitive = IntArray(raster.size.toInt())
        }

        override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
            val width = raster.width
            System.arraycopy(argb, 0, this.argb, y * width, width)
            System.arraycopy(depth, 0, this.depth, y * width, width)
            System.arraycopy(primitive, 0, this.primitive, y * width, width)
        }

        /** Returns the image. Call it once, after the last row. */
        public fun toImage(counters: Counters): Image =
            Image(raster.width, raster.height, argb, depth, primitive, counters)
    }

    private companion object {
        const val MAX_SAMPLES: Long = Int.MAX_VALUE - 8L
    }
}

/** The identity of a picture, fed row by row; see [Image.pixelHash]. Not thread safe. */
public class PixelHash {
    private val sha = MessageDigest.getInstance("SHA-256")
    private var bytes = ByteArray(0)

    /** Adds the first [width] colours of a row, `0xAARRGGBB`. */
    public fun add(argb: IntArray, width: Int) {
        if (bytes.size < 4 * width) bytes = ByteArray(4 * width)
        for (x in 0 until width) {
            val color = argb[x]
            bytes[4 * x] = (color ushr 24).toByte()
            bytes[4 * x + 1] = (color ushr 16).toByte()
            bytes[4 * x + 2] = (color ushr 8).toByte()
            bytes[4 * x + 3] = color.toByte()
        }
        sha.update(bytes, 0, 4 * width)
    }

    /** Returns the hash of the rows so far as 64 hexadecimal digits, and starts anew. */
    public fun digest(): String = sha.digest().joinToString("") { "%02x".format(it) }
}
