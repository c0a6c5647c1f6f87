package dev.lazyz.filter

import java.util.Arrays

/** Runs of pixels in a row of samples. */
internal object PixelRuns {
    /**
     * Returns the end of the pixels from [x] on whose samples, [factor] of each, have the same [values]; [x] if its own
     * have not. The row has [width] pixels.
     */
    fun end(values: IntArray, x: Int, factor: Int, width: Int): Int {
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
}
