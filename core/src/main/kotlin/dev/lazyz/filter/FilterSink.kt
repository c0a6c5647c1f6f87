package dev.lazyz.filter

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.filter.LightSums.CHANNELS
import dev.lazyz.filter.SuperSampling.PixelFilter
import kotlin.math.ceil
import kotlin.math.round

/**
 * Receives the rows of samples of [frame], and passes on the rows of [pixels]. See [SuperSampling].
 *
 * Light is added as in [LightSums], times the integer weights of [taps]: 64-bit sums are exact. Belongs to one
 * rendering.
 */
internal class FilterSink(
    private val taps: FilterTaps,
    private val frame: Frame,
    private val pixels: Region,
    private val sink: RowSink,
) : RowSink {
    private val factor = taps.factor
    private val test = frame.raster.depthTest
    private val samples = frame.region
    private val width = pixels.width

    /** The sums of one row of samples: red, green, blue and alpha of each pixel. */
    private val across = LongArray(CHANNELS * width)

    /** The sums of the rows of pixels that are not complete. Row y is number y modulo the length. */
    private val sums = Array(rows(taps, pixels)) { LongArray(CHANNELS * width) }

    /** By row, as [sums]: the key of the nearest sample of each pixel, and the colour of its upper left sample. */
    private val keys = Array(sums.size) { LongArray(width) }
    private val corners = Array(sums.size) { IntArray(width) }
    private val columnWeights = LongArray(width) {
        taps.sum(pixels.columnStart + it, samples.columnStart, samples.columnEnd)
    }

    private val argb = IntArray(width)
    private val depths = IntArray(width)
    private val indices = IntArray(width)

    /** The first row that is not passed on. */
    private var next = pixels.rowStart

    /** The first row that has not begun. */
    private var open = pixels.rowStart

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        sumAcross(argb)
        while (open < pixels.rowEnd && taps.first(open) <= y) begin(open++)
        for (row in next until open) if (y < taps.end(row)) addRow(row, taps.weights[y - taps.first(row)].toLong())
        val own = y / factor
        if (own in next until open) keepNearest(own, y % factor == 0, argb, depth, primitive)
        while (next < open && (y == taps.end(next) - 1 || y == samples.rowEnd - 1)) end(next++)
    }

    private fun begin(row: Int) {
        sums[row % sums.size].fill(0)
        keys[row % sums.size].fill(Long.MAX_VALUE)
    }

    /** Sums up a row of samples for every pixel. */
    private fun sumAcross(argb: IntArray) {
        val weights = taps.weights
        across.fill(0)
        for (x in 0 until width) {
            val first = taps.first(pixels.columnStart + x)
            val start = maxOf(first, samples.columnStart)
            val end = minOf(taps.end(pixels.columnStart + x), samples.columnEnd)
            LightSums.add(across, CHANNELS * x, argb, start - samples.columnStart, end - samples.columnStart) {
                weights[it + samples.columnStart - first]
            }
        }
    }

    private fun addRow(row: Int, weight: Long) {
        val to = sums[row % sums.size]
        for (i in to.indices) to[i] += weight * across[i]
    }

    /** Keeps the nearest sample of every pixel. Only the samples of the pixel itself count. */
    private fun keepNearest(row: Int, isFirst: Boolean, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val best = keys[row % sums.size]
        for (x in 0 until width) {
            val start = (pixels.columnStart + x) * factor - samples.columnStart
            var key = best[x]
            for (i in start until start + factor) key = minOf(key, test.key(depth[i], primitive[i]))
            best[x] = key
            if (isFirst) corners[row % sums.size][x] = argb[start]
        }
    }

    private fun end(row: Int) {
        val from = sums[row % sums.size]
        val best = keys[row % sums.size]
        val rowWeight = taps.sum(row, samples.rowStart, samples.rowEnd)
        for (x in 0 until width) {
            argb[x] = LightSums.mean(from, CHANNELS * x, rowWeight * columnWeights[x], corners[row % sums.size][x])
            depths[x] = test.depthOf(best[x])
            indices[x] = test.indexOf(best[x])
        }
        sink.row(row, argb, depths, indices)
    }

    companion object {
        /** Bytes of a column besides those of rows: its sums of a row, its weight, and what is passed on. */
        private const val COLUMN_BYTES = 8L * CHANNELS + 8 + 3 * 4

        /** Bytes of a column of each row that is not complete: sums, key, and colour. */
        private const val ROW_BYTES = 8L * CHANNELS + 8 + 4

        /** Number of rows of [pixels] that are not complete at a time. */
        private fun rows(taps: FilterTaps, pixels: Region): Int =
            minOf((taps.weights.size + taps.factor - 1) / taps.factor + 1, pixels.height)

        /** Bytes held for [pixels]. */
        fun bytes(taps: FilterTaps, pixels: Region): Long =
            pixels.width * (COLUMN_BYTES + ROW_BYTES * rows(taps, pixels))
    }
}

/**
 * The weights of the samples of a pixel in one direction, as integers, so that sums are exact. Immutable.
 *
 * @property factor samples a pixel in each direction
 */
internal class FilterTaps(filter: PixelFilter, val factor: Int) {
    /** Number of samples that count before the first sample of the pixel, and after the last. */
    val margin: Int = if (filter == PixelFilter.BOX) 0 else ceil((filter.radius - 0.5) * factor).toInt()

    /** The weights from the first sample that counts on. For [PixelFilter.BOX] all are 1. */
    val weights: IntArray = IntArray(factor + 2 * margin) {
        val distance = (it - margin + 0.5) / factor - 0.5
        if (filter == PixelFilter.BOX) 1 else round(filter.weight(distance) * UNIT / factor).toInt()
    }

    /** The first sample that counts for pixel [pixel]. It may be before the raster. */
    fun first(pixel: Int): Int = pixel * factor - margin

    /** The end of the samples that count for pixel [pixel]. It may be behind the raster. */
    fun end(pixel: Int): Int = (pixel + 1) * factor + margin

    /** Returns the sum of the weights of pixel [pixel] for the samples from [start] until [end]. */
    fun sum(pixel: Int, start: Int, end: Int): Long {
        var sum = 0L
        for (i in maxOf(start, first(pixel)) until minOf(end, end(pixel))) sum += weights[i - first(pixel)]
        return sum
    }

    private companion object {
        /**
         * About the sum of all weights, 2^14: so large that rounding does not show, and so small that the sums of
         * [FilterSink] fit into 64 bits: 14 bits for the columns, 14 for the rows, 24 of light and 8 of alpha.
         */
        const val UNIT = 16384.0
    }
}
