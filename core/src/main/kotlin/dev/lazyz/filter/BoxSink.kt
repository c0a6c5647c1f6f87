package dev.lazyz.filter

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.filter.LightSums.CHANNELS
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.spi.Srgb
import java.util.Arrays

/**
 * Receives the rows of samples of a frame, and passes on the rows of pixels, each the mean of its own samples. They are
 * those of a [FilterSink] with [PixelFilter.BOX].
 *
 * Most pixels of a picture have samples of one colour, which is that of the pixel: only the others are added up.
 * Belongs to one rendering.
 *
 * @param factor samples a pixel in each direction
 */
internal class BoxSink(private val factor: Int, frame: Frame, pixels: Region, private val sink: RowSink) : RowSink {
    private val test = frame.raster.depthTest
    private val width = pixels.width
    private val samplesOfPixel = factor.toLong() * factor

    /** The colour of the upper left sample of each pixel. While the pixel is not mixed, that of all its samples. */
    private val corners = IntArray(width)

    /** Whether samples of a pixel have different colours, so that there are sums of them. */
    private val isMixed = BooleanArray(width)

    /** The sums of mixed pixels: red, green, blue and alpha. */
    private val sums = LongArray(CHANNELS * width)

    /** The keys of the nearest samples. */
    private val keys = LongArray(width)

    private val argb = IntArray(width)
    private val depths = IntArray(width)
    private val indices = IntArray(width)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val row = y % factor
        var x = 0
        while (x < width) {
            if (row > 0 && isMixed[x]) {
                uneven(row, x++, argb)
                continue
            }
            val end = endOfRun(argb, x, factor, width)
            if (end > x) even(row, x, end, argb[factor * x]) else uneven(row, x, argb)
            x = maxOf(end, x + 1)
        }
        samples(y, depth, primitive)
        if (row == factor - 1) end(y / factor)
    }

    /** Takes a row of samples of the pixels [start] until [end], all of the same [color]. */
    private fun even(row: Int, start: Int, end: Int, color: Int) {
        if (row == 0) return fill(start, end, color)
        for (x in start until end) {
            if (!isMixed[x]) {
                if (corners[x] == color) continue
                mix(x, row)
            }
            add(x, color, factor.toLong())
        }
    }

    /** Takes a row of samples of the pixel [x]. */
    private fun uneven(row: Int, x: Int, argb: IntArray) {
        val start = factor * x
        if (row == 0) corners[x] = argb[start]
        if (row == 0 || !isMixed[x]) mix(x, row)
        LightSums.add(sums, CHANNELS * x, argb, start, start + factor) { 1 }
    }

    /** Begins the sums of the pixel [x] with its [rows] rows so far. */
    private fun mix(x: Int, rows: Int) {
        isMixed[x] = true
        sums.fill(0, CHANNELS * x, CHANNELS * (x + 1))
        if (rows > 0) add(x, corners[x], factor.toLong() * rows)
    }

    private fun add(x: Int, color: Int, count: Long) = LightSums.add(sums, CHANNELS * x, color, count)

    private fun fill(start: Int, end: Int, color: Int) {
        if (end - start < LONG) {
            for (x in start until end) {
                corners[x] = color
                isMixed[x] = false
            }
        } else {
            corners.fill(color, start, end)
            isMixed.fill(false, start, end)
        }
    }

    /** Keeps the nearest sample of each pixel. */
    private fun samples(y: Int, depth: IntArray, primitive: IntArray) {
        if (y % factor == 0) keys.fill(Long.MAX_VALUE)
        var x = 0
        while (x < width) {
            val start = factor * x
            val end = if (primitive[start] == DepthTest.BACKGROUND) endOfRun(primitive, x, factor, width) else x
            if (end > x) {
                // All samples of the background have the same depth
                val empty = test.key(depth[start], DepthTest.BACKGROUND)
                while (x < end) {
                    keys[x] = minOf(keys[x], empty)
                    x++
                }
            } else {
                var key = keys[x]
                for (i in start until start + factor) key = minOf(key, test.key(depth[i], primitive[i]))
                keys[x++] = key
            }
        }
    }

    private fun end(y: Int) {
        for (x in 0 until width) {
            val isPlain = !isMixed[x]
            argb[x] = if (isPlain) corners[x] else LightSums.mean(sums, CHANNELS * x, samplesOfPixel, corners[x])
            depths[x] = test.depthOf(keys[x])
            indices[x] = test.indexOf(keys[x])
        }
        sink.row(y, argb, depths, indices)
    }

    companion object {
        /** Fewest pixels for which filling by whole arrays is worthwhile. */
        private const val LONG = 8

        /** Bytes of a pixel: its sums and key; its corner and what is passed on; whether it is mixed. */
        private const val PIXEL_BYTES = 8L * CHANNELS + 8 + 4 * 4 + 1

        /**
         * Returns the end of the pixels from [x] on whose samples, [factor] of each, have the same [values]; [x] if its
         * own have not. The row has [width] pixels.
         */
        fun endOfRun(values: IntArray, x: Int, factor: Int, width: Int): Int {
            val start = factor * x
            val value = values[start]
            for (i in start + 1 until start + factor) if (values[i] != value) return x
            val next = start + factor
            val last = factor * width
            if (next >= last || values[next] != value) return x + 1

            // The number of samples that are equal to the one before
            val equal = Arrays.mismatch(values, start, last - 1, values, start + 1, last)
            return if (equal < 0) width else x + (equal + 1) / factor
        }

        /** Bytes held for [pixels]. */
        fun bytes(pixels: Region): Long = PIXEL_BYTES * pixels.width
    }
}

/**
 * Means of colours in linear light. Light is added as integers of [LIGHT_BITS] bits, times the 8-bit alpha and a
 * weight: sums are exact, and their order does not matter.
 */
internal object LightSums {
    /** Red, green, blue and alpha. */
    const val CHANNELS: Int = 4
    const val ALPHA: Int = 3
    const val LIGHT_BITS: Int = 24

    /** The light of each sRGB code, 0..2^[LIGHT_BITS]; not to be changed. */
    val LIGHT: IntArray = IntArray(256) { (Srgb.decode(it / 255.0) * (1 shl LIGHT_BITS) + 0.5).toInt() }

    /** Passes the light and the alpha of a sample with the colour [color], `0xAARRGGBB`, times [weight] to [use]. */
    inline fun of(color: Int, weight: Long, use: (red: Long, green: Long, blue: Long, alpha: Long) -> Unit) {
        val alpha = weight * (color ushr 24)
        val red = alpha * LIGHT[color shr 16 and 0xFF]
        val green = alpha * LIGHT[color shr 8 and 0xFF]
        use(red, green, alpha * LIGHT[color and 0xFF], alpha)
    }

    /** Adds [count] samples of [color], `0xAARRGGBB`, to the sums from [at] on. */
    fun add(sums: LongArray, at: Int, color: Int, count: Long) {
        of(color, count) { red, green, blue, alpha ->
            sums[at] += red
            sums[at + 1] += green
            sums[at + 2] += blue
            sums[at + ALPHA] += alpha
        }
    }

    /** Adds the colours [start] until [end] of [argb] to the sums from [at] on, each as often as [weight] returns. */
    inline fun add(sums: LongArray, at: Int, argb: IntArray, start: Int, end: Int, weight: (i: Int) -> Int) {
        var red = 0L
        var green = 0L
        var blue = 0L
        var alpha = 0L
        for (i in start until end) {
            of(argb[i], weight(i).toLong()) { r, g, b, a ->
                red += r
                green += g
                blue += b
                alpha += a
            }
        }
        sums[at] += red
        sums[at + 1] += green
        sums[at + 2] += blue
        sums[at + ALPHA] += alpha
    }

    /**
     * Returns the mean, `0xAARRGGBB`, of the sums from [at] on: red, green, blue and alpha. Where there is no alpha, it
     * has the colour of [corner].
     *
     * @param weight the sum of the weights
     * @param bits of light; fewer if the sums of the colours were divided by a power of two
     */
    fun mean(sums: LongArray, at: Int, weight: Long, corner: Int, bits: Int = LIGHT_BITS): Int {
        val alpha = sums[at + ALPHA]
        if (alpha <= 0L) return corner and 0xFFFFFF
        val opacity = minOf((2 * alpha + weight) / (2 * weight), 255L).toInt()
        val light = alpha.toDouble() * (1 shl bits)
        return opacity shl 24 or (code(sums[at], light) shl 16) or (code(sums[at + 1], light) shl 8) or
            code(sums[at + 2], light)
    }

    /** Returns the sRGB code of the light whose sum is [sum], where white has the sum [white]. */
    private fun code(sum: Long, white: Double): Int = Srgb.encode((sum.toDouble() / white).toFloat())
}
