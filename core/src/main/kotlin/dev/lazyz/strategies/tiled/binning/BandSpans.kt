package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Counters
import dev.lazyz.Primitive
import dev.lazyz.Spans
import dev.lazyz.strategies.tiled.raster.Checkpoint
import java.util.concurrent.atomic.AtomicLong

/**
 * The spans of a primitive in one band, for the tiles that share it: scan-converted once, by the first thread that
 * wants them.
 *
 * Going through a polygon's edges, or a mask's texels, once for every tile that its rows cross would cost as much again
 * for each. Thread safe.
 *
 * @param rowStart first row of the primitive in the band
 * @param rowEnd the row after the last
 * @param bytes counts what is held
 */
internal class BandSpans(
    private val primitive: Primitive,
    private val rowStart: Int,
    private val rowEnd: Int,
    private val bytes: AtomicLong,
) {
    /** The rows, once they are known. */
    @Volatile
    private var rows: Rows? = null

    /**
     * Row by row, the first and the column after the last of each span; [ends] says where in [bounds] a row ends.
     *
     * @property first the row with the number 0
     */
    class Rows(val first: Int, private val ends: IntArray, private val bounds: IntArray) {
        /** Number of rows. */
        val count: Int get() = ends.size

        /** Where row number [row] begins. */
        private fun begin(row: Int): Int = if (row == 0) 0 else ends[row - 1]

        /** Where row number [row] ends. */
        fun end(row: Int): Int = ends[row]

        /** Column at which a span begins. */
        fun start(at: Int): Int = bounds[at]

        /** Column after the last of the span that begins at [at]. */
        fun until(at: Int): Int = bounds[at + 1]

        /** Returns the place of the first span of row number [row] that ends behind column [x]; [end] if none does. */
        fun firstBehind(row: Int, x: Int): Int {
            var low = begin(row) / 2
            var high = end(row) / 2
            while (low < high) {
                val middle = (low + high) ushr 1
                if (bounds[2 * middle + 1] > x) high = middle else low = middle + 1
            }
            return 2 * low
        }
    }

    /**
     * Returns the rows. Whoever is the first to want them counts the fragments, of all tiles, in [counters]; [scratch]
     * keeps the columns of the region, and [checkpoint] is passed before each row.
     */
    fun rows(scratch: Spans, counters: Counters, checkpoint: Checkpoint): Rows =
        rows ?: synchronized(this) { rows ?: scan(scratch, counters, checkpoint).also { rows = it } }

    private fun scan(scratch: Spans, counters: Counters, checkpoint: Checkpoint): Rows {
        val cursor = primitive.cursor(rowStart)
        val ends = IntArray(rowEnd - rowStart)
        var bounds = IntArray(2 * ends.size)
        var used = 0
        for (row in ends.indices) {
            checkpoint.pass()
            cursor.next(scratch)
            if (used + 2 * scratch.count > bounds.size) bounds = bounds.copyOf(2 * (used + 2 * scratch.count))
            for (i in 0 until scratch.count) {
                bounds[used++] = scratch.start(i)
                bounds[used++] = scratch.end(i)
                counters.fragments += scratch.end(i) - scratch.start(i)
            }
            ends[row] = used
        }
        bytes.addAndGet(BYTES + Int.SIZE_BYTES * (ends.size + bounds.size).toLong())
        return Rows(rowStart, ends, bounds)
    }

    private companion object {
        /** Two objects of a header and four fields, and the headers of two arrays. */
        const val BYTES = 96L
    }
}
