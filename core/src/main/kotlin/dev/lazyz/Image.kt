package dev.lazyz

import java.security.MessageDigest
import java.util.BitSet
import java.util.HexFormat

/**
 * A rendered image: a colour, a depth and the index of the visible primitive for each sample.
 *
 * Two images are equal if their regions, colours, depths and primitives are equal, bit for bit (contract rule 7.1).
 * The arrays are not copied; do not change them. Immutable and thread safe.
 *
 * @property region the samples of the raster that the image shows; usually the whole raster
 * @property argb colours in rows from the top, 8-bit sRGB with straight alpha, `0xAARRGGBB`
 * @property depth depths in rows from the top, 0..2^31-1, see [Depth]
 * @property primitive submission index of the visible primitive, or [DepthTest.BACKGROUND], in rows from the top
 * @property counters the work that the rendering took
 * @throws IllegalArgumentException if an array does not have one element for each sample of [region]
 */
public class Image(
    public val region: Region,
    public val argb: IntArray,
    public val depth: IntArray,
    public val primitive: IntArray,
    public val counters: Counters,
) {
    init {
        val size = region.size
        require(argb.size.toLong() == size && depth.size.toLong() == size && primitive.size.toLong() == size) {
            "an image of $width x $height needs $size samples: ${argb.size}, ${depth.size}, ${primitive.size}"
        }
    }

    /** An image of a whole raster of [width] x [height] samples. */
    public constructor(
        width: Int,
        height: Int,
        argb: IntArray,
        depth: IntArray,
        primitive: IntArray,
        counters: Counters,
    ) : this(Region(0, 0, width, height), argb, depth, primitive, counters)

    /** Number of columns. */
    public val width: Int get() = region.width

    /** Number of rows. */
    public val height: Int get() = region.height

    /** Number of samples at which a primitive is visible. Cost: one pass over the samples. */
    public val visible: Int get() = primitive.count { it != DepthTest.BACKGROUND }

    /**
     * Returns the colour at column [x] and row [y] of the raster, `0xAARRGGBB`.
     *
     * @throws IllegalArgumentException if the sample is not in [region]
     */
    public fun argb(x: Int, y: Int): Int = argb[index(x, y)]

    /**
     * Returns the depth at column [x] and row [y] of the raster, 0..2^31-1.
     *
     * @throws IllegalArgumentException if the sample is not in [region]
     */
    public fun depth(x: Int, y: Int): Int = depth[index(x, y)]

    /**
     * Returns the submission index of the primitive visible at column [x] and row [y] of the raster, or
     * [DepthTest.BACKGROUND].
     *
     * @throws IllegalArgumentException if the sample is not in [region]
     */
    public fun primitive(x: Int, y: Int): Int = primitive[index(x, y)]

    /**
     * Returns the pixel hash: the SHA-256 of the colours, four bytes a sample in the order alpha, red, green, blue, in
     * rows from the top, as 64 hexadecimal digits (contract rule 7.2). Width and height are not part of it. Cost: one
     * pass over the samples.
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
        require(region.contains(x, y)) { "sample must be within $region: ($x, $y)" }
        return (y - region.rowStart) * width + (x - region.columnStart)
    }

    override fun equals(other: Any?): Boolean = other is Image && region == other.region &&
        argb.contentEquals(other.argb) && depth.contentEquals(other.depth) && primitive.contentEquals(other.primitive)

    override fun hashCode(): Int = argb.contentHashCode() * 31 + depth.contentHashCode()

    override fun toString(): String = "Image($region, $visible visible, ${pixelHash().take(12)})"

    /**
     * A sink that collects all rows of [region] in memory, in any order. Not thread safe.
     *
     * @throws IllegalArgumentException if the region has more than 2^31-9 samples: stream its rows instead
     */
    public class Collector(private val region: Region) : RowSink {
        private val argb: IntArray
        private val depth: IntArray
        private val primitive: IntArray

        /** The rows so far, counted from the first of the region. */
        private val rows = BitSet()

        init {
            require(region.size <= MAX_SAMPLES) {
                "an image in memory has at most $MAX_SAMPLES samples, stream the rows instead: ${region.size}"
            }
            argb = IntArray(region.size.toInt())
            depth = IntArray(region.size.toInt())
            primitive = IntArray(region.size.toInt())
        }

        /**
         * Copies row [y].
         *
         * @throws IllegalArgumentException if the region has no such row, the row was given before, or an array has
         *   fewer columns than the region
         */
        override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
            require(y in region.rowStart until region.rowEnd) {
                "row must be in ${region.rowStart}..<${region.rowEnd}: $y"
            }
            val columns = minOf(argb.size, depth.size, primitive.size)
            require(columns >= region.width) { "row $y has $columns columns, and the image has ${region.width}" }
            val row = y - region.rowStart
            require(!rows[row]) { "row $y was given before" }
            rows.set(row)
            val at = row * region.width
            System.arraycopy(argb, 0, this.argb, at, region.width)
            System.arraycopy(depth, 0, this.depth, at, region.width)
            System.arraycopy(primitive, 0, this.primitive, at, region.width)
        }

        /**
         * Returns the image, without copying. Call it once, after the last row.
         *
         * @throws IllegalStateException if a row is missing
         */
        public fun toImage(counters: Counters): Image {
            val row = rows.nextClearBit(0)
            check(row == region.height) {
                "row ${region.rowStart + row} is missing: there are ${rows.cardinality()} of ${region.height} rows"
            }
            return Image(region, argb, depth, primitive, counters)
        }
    }

    /** Computes [Image.pixelHash] row by row. Not thread safe. */
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

        /** Returns the hash of the rows so far as 64 hexadecimal digits, and resets. */
        public fun digest(): String = HexFormat.of().formatHex(sha.digest())
    }

    public companion object {
        /** Most samples of an image, and of anything else with an array element for each sample. */
        internal const val MAX_SAMPLES: Long = Int.MAX_VALUE - 8L

        /**
         * Merges two images of parts of one frame (split by primitives, see [Frame.keeping], or by regions, see
         * [Frame.within]). Each sample shows what is visible by the depth test of [raster].
         *
         * The result is the minimum of a total order, so merging is associative, commutative and idempotent, and an
         * image without primitives is its identity (contract rule 5.1). The result covers the smallest region that
         * contains both; samples outside both parts show the background. Counters are added as by [Counters.plus].
         *
         * Regions of an anti-aliased image can be merged, too, but not parts that are split by primitives: colours of
         * several samples are not merged.
         *
         * @throws IllegalArgumentException if an image is not within [raster], or if the result would have more than
         *   2^31-9 samples
         */
        @JvmStatic
        public fun merge(first: Image, second: Image, raster: Raster): Image {
            for (part in listOf(first, second)) {
                require(raster.region.contains(part.region)) { "${part.region} is not within ${raster.region}" }
            }
            val region = first.region.union(second.region)
            val size = region.size
            require(size <= MAX_SAMPLES) { "an image in memory has at most $MAX_SAMPLES samples: $size" }
            val background = raster.background.toArgb()
            val merged = Image(
                region,
                IntArray(size.toInt()) { background },
                IntArray(size.toInt()) { raster.backgroundDepth },
                IntArray(size.toInt()) { DepthTest.BACKGROUND },
                first.counters.plus(second.counters),
            )
            for (part in listOf(first, second)) {
                for (y in part.region.rowStart until part.region.rowEnd) {
                    for (x in part.region.columnStart until part.region.columnEnd) {
                        val from = part.index(x, y)
                        val to = merged.index(x, y)
                        val key = raster.depthTest.key(part.depth[from], part.primitive[from])
                        val mergedKey = raster.depthTest.key(merged.depth[to], merged.primitive[to])

                        // Wide filters give samples without a primitive the colour of others nearby
                        val isPlain = merged.primitive[to] == DepthTest.BACKGROUND && merged.argb[to] == background
                        if (key < mergedKey || (key == mergedKey && isPlain)) {
                            merged.argb[to] = part.argb[from]
                            merged.depth[to] = part.depth[from]
                            merged.primitive[to] = part.primitive[from]
                        }
                    }
                }
            }
            return merged
        }
    }
}
