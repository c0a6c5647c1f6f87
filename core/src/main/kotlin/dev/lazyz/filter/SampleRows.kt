package dev.lazyz.filter

import dev.lazyz.RowSink

/**
 * Makes rows of samples of the pixels that it receives, and passes them to [sink]. Belongs to one rendering.
 *
 * @param factor samples a pixel in each direction
 * @param width samples in a row
 */
internal class SampleRows(private val factor: Int, private val width: Int, private val sink: RowSink) : PixelSink {
    private val argb = Array(factor) { IntArray(width) }
    private val depths = Array(factor) { IntArray(width) }
    private val indices = Array(factor) { IntArray(width) }

    override fun samples(y: Int, depth: IntArray, primitive: IntArray) {
        depth.copyInto(depths[y % factor], 0, 0, width)
        primitive.copyInto(indices[y % factor], 0, 0, width)
    }

    override fun even(start: Int, end: Int, color: Int) {
        for (row in argb) row.fill(color, factor * start, factor * end)
    }

    override fun mixed(x: Int, colors: IntArray) {
        for (row in 0 until factor) colors.copyInto(argb[row], factor * x, factor * row, factor * (row + 1))
    }

    override fun end(y: Int) {
        for (row in 0 until factor) sink.row(factor * y + row, argb[row], depths[row], indices[row])
    }

    companion object {
        /** Bytes of a sample: colour, depth and primitive. */
        private const val SAMPLE_BYTES = 12L

        /** Bytes held for rows of [width] samples, [factor] x [factor] a pixel. */
        fun bytes(factor: Int, width: Int): Long = SAMPLE_BYTES * factor * width
    }
}
