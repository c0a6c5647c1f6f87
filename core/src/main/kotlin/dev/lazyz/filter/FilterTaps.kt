package dev.lazyz.filter

import kotlin.math.ceil
import kotlin.math.round

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
