package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Region
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs

/**
 * How a picture differs from the expected one. Created by [between]. Immutable and thread safe.
 *
 * Differences are in codes of 8 bits: 1 is the smallest step of a channel of a usual PNG, 255 the greatest difference.
 * Pictures with 16 bits a channel can differ by fractions. A pixel differs if one of its channels, alpha included,
 * differs by more than [threshold]; with a threshold of 0, if any bit of it differs. This holds for transparent pixels,
 * too: their colours count.
 *
 * @property expected the picture as it should be
 * @property actual the picture as it is
 * @property threshold the greatest difference of a channel that is accepted, 0..255
 * @property differingPixels number of pixels that differ by more than [threshold]; 0 if the sizes differ
 * @property largest greatest difference of a channel, 0..255; 0 if the sizes differ
 * @property mean mean difference of all channels of all pixels, 0..255; 0 if the sizes differ
 * @property first the first pixel that differs by more than [threshold], in rows from the top, or null
 * @property bounds the smallest rectangle with all such pixels, or null
 */
public class PictureDifference private constructor(
    public val expected: Picture,
    public val actual: Picture,
    public val threshold: Double,
    public val differingPixels: Long,
    public val largest: Double,
    public val mean: Double,
    public val first: PixelDifference?,
    public val bounds: Region?,
) {
    /** Whether both pictures have the same width and height. */
    public val isSameSize: Boolean get() = expected.width == actual.width && expected.height == actual.height

    /** Whether all pixels are the same, without tolerance. */
    public val isIdentical: Boolean get() = isSameSize && largest == 0.0

    /** Whether the sizes are the same, and no channel of a pixel differs by more than [threshold]. */
    public val isMatch: Boolean get() = isSameSize && differingPixels == 0L

    /** What differs, in one to three lines without a line break at the end. */
    public val summary: String
        get() = when {
            !isSameSize ->
                "the sizes differ: expected ${expected.width}x${expected.height}, " +
                    "but was ${actual.width}x${actual.height}"

            isIdentical && pixels == 1L -> "the only pixel is the same"

            isIdentical -> "all ${readable(pixels)} pixels are the same"

            first == null -> "no pixel differs by more than ${readable(threshold)}\n$amount"

            else -> {
                val by = if (threshold == 0.0) "" else " by more than ${readable(threshold)}"
                "${readable(differingPixels)} of ${readable(pixels)} pixels differ$by, within $rectangle\n" +
                    "first at $first\n$amount"
            }
        }

    private val pixels: Long get() = expected.width.toLong() * expected.height

    private val rectangle: String
        get() = checkNotNull(bounds).let {
            "columns ${it.columnStart} to ${it.columnEnd - 1}, rows ${it.rowStart} to ${it.rowEnd - 1}"
        }

    private val amount: String
        get() = "largest difference of a channel: ${readable(largest)} of 255; mean: ${readable(mean)}"

    /**
     * Returns a picture of where the pictures differ. Pixels that differ by more than [threshold] are yellow, and
     * redder the more they differ; pixels that only one of the pictures has are blue; all others are pale, in the grey
     * of the expected picture. It is opaque and as large as the larger picture in each direction; it has no depth.
     *
     * @throws IllegalArgumentException if that is more than 2^31 - 9 pixels; the message says so
     */
    public fun toImage(): Image {
        val width = maxOf(expected.width, actual.width)
        val height = maxOf(expected.height, actual.height)
        val pixels = width.toLong() * height
        require(pixels <= MOST_PIXELS) {
            "a picture of the difference has ${width}x$height pixels, and an image in memory at most $MOST_PIXELS"
        }
        val size = pixels.toInt()
        val allowed = allowed(threshold)
        val argb = IntArray(size) { shown(it % width, it / width, allowed) }
        return Image(width, height, argb, IntArray(size), IntArray(size) { DepthTest.BACKGROUND }, Counters.NONE)
    }

    private fun shown(x: Int, y: Int, allowed: Int): Int {
        val isInBoth = x < minOf(expected.width, actual.width) && y < minOf(expected.height, actual.height)
        if (!isInBoth) return OUTSIDE
        val difference = largestOf(expected.argb(x, y), actual.argb(x, y))
        if (difference > allowed) return MARKED or (YELLOW * (MOST - difference) / MOST shl 8)
        return pale(expected.argb(x, y))
    }

    override fun toString(): String = summary.replace("\n", "; ")

    public companion object {
        /** One code of 8 bits in codes of 16 bits. */
        private const val CODE = 257

        /** The greatest code of 16 bits. */
        private const val MOST = 65535

        private const val MOST_PIXELS = Int.MAX_VALUE - 8L

        /** The bits at which the channels of a pixel begin. */
        private val CHANNELS = intArrayOf(48, 32, 16, 0)
        private const val MARKED = 0xFFFF0000.toInt()
        private const val OUTSIDE = 0xFF4060FF.toInt()

        /** The green of the smallest difference. */
        private const val YELLOW = 208

        /** The darkest grey of pixels that do not differ. */
        private const val PALE = 192

        /**
         * Compares [actual] with [expected]. Cost: one pass over the pixels.
         *
         * @param threshold the greatest difference of a channel that is accepted, in codes of 8 bits, 0..255. The
         *   default is 0: Lazy Z gives the same bits on every machine, so a difference is a change
         * @throws IllegalArgumentException if [threshold] is out of range
         */
        @JvmStatic
        @JvmOverloads
        public fun between(expected: Picture, actual: Picture, threshold: Double = 0.0): PictureDifference {
            require(threshold in 0.0..255.0) { "threshold must be in 0..255: $threshold" }
            if (expected.width != actual.width || expected.height != actual.height) {
                return PictureDifference(expected, actual, threshold, 0, 0.0, 0.0, null, null)
            }
            val allowed = allowed(threshold)
            var differing = 0L
            var largest = 0
            var sum = 0L
            var first: PixelDifference? = null
            var left = Int.MAX_VALUE
            var right = 0
            var bottom = 0
            for (y in 0 until expected.height) {
                for (x in 0 until expected.width) {
                    val wanted = expected.argb(x, y)
                    val found = actual.argb(x, y)
                    if (wanted == found) continue
                    val difference = largestOf(wanted, found)
                    largest = maxOf(largest, difference)
                    sum += sumOf(wanted, found)
                    if (difference <= allowed) continue
                    differing++
                    left = minOf(left, x)
                    right = maxOf(right, x + 1)
                    bottom = y + 1
                    if (first == null) first = PixelDifference(x, y, expected.color(x, y), actual.color(x, y))
                }
            }
            val channels = 4.0 * expected.width * expected.height
            val bounds = first?.let { Region(left, it.y, right, bottom) }
            return PictureDifference(
                expected,
                actual,
                threshold,
                differing,
                largest.toDouble() / CODE,
                sum.toDouble() / CODE / channels,
                first,
                bounds,
            )
        }

        /** The greatest difference in codes of 16 bits that is within [threshold]. */
        private fun allowed(threshold: Double): Int = (threshold * CODE).toInt()

        private fun largestOf(first: Long, second: Long): Int = CHANNELS.maxOf { channel(first, second, it) }

        private fun sumOf(first: Long, second: Long): Int = CHANNELS.sumOf { channel(first, second, it) }

        /** Difference of the channel that begins at bit [shift]. */
        private fun channel(first: Long, second: Long, shift: Int): Int =
            abs((first ushr shift and 0xFFFF).toInt() - (second ushr shift and 0xFFFF).toInt())

        /** A light grey for a pixel that does not differ. */
        internal fun pale(argb: Long): Int {
            val sum = CHANNELS.drop(1).sumOf { (argb ushr it + 8 and 0xFF).toInt() }
            val grey = PALE + sum * (255 - PALE) / (3 * 255)
            return 0xFF shl 24 or (grey shl 16) or (grey shl 8) or grey
        }

        private fun readable(number: Long): String = "%,d".format(null, number)

        /** At most three digits other than leading zeros. */
        private fun readable(number: Double): String =
            BigDecimal(number).round(MathContext(3)).stripTrailingZeros().toPlainString()
    }
}

/**
 * A pixel that has another colour than it should.
 *
 * @property x its column, from 0
 * @property y its row, from 0 at the top
 * @property expected the colour that it should have, see [Picture.color]
 * @property actual the colour that it has
 */
public class PixelDifference internal constructor(
    public val x: Int,
    public val y: Int,
    public val expected: String,
    public val actual: String,
) {
    override fun toString(): String = "column $x, row $y: expected $expected, but was $actual"
}
