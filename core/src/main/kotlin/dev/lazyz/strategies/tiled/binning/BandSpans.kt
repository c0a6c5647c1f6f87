package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.bytes
import dev.lazyz.spi.Spans
import java.util.concurrent.atomic.AtomicLong

/**
 * The spans of a primitive in one band, for the tiles that share it. The first thread that needs them scan-converts the
 * primitive, once.
 *
 * Without sharing, the polygon's edges or the mask's texels would be processed again for each tile that the rows cross.
 * Thread safe.
 *
 * @param rowStart first row of the primitive in the band
 * @param rowEnd the row after the last
 * @param bytes counter of the bytes held
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
     * The spans of each row: [bounds] holds the first column of each span and the column after its last, row by row;
     * [ends] holds the position in [bounds] where each row ends.
     *
     * @property first the row with the number 0
     */
    class Rows(val first: Int, private val ends: IntArray, private val bounds: IntArray) {
        /** Number of rows. */
        val count: Int get() = ends.size

        /** Position where row number [row] starts. */
        private fun begin(row: Int): Int = if (row == 0) 0 else ends[row - 1]

        /** Position where row number [row] ends. */
        fun end(row: Int): Int = ends[row]

        /** First column of the span at position [at]. */
        fun start(at: Int): Int = bounds[at]

        /** Column after the last of the span at position [at]. */
        fun until(at: Int): Int = bounds[at + 1]

        /**
         * Returns the position of the first span of row number [row] that ends after column [x], or [end] if none does.
         */
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
     * Returns the rows. The first call counts the fragments of all tiles in [counters]. [scratch] must be limited to
     * the columns of the region; [checkpoint] is called before each row.
     */
    fun rows(scratch: Spans, counters: Counters.Builder, checkpoint: Checkpoint): Rows =
        rows ?: synchronized(this) { rows ?: scan(scratch, counters, checkpoint).also { rows = it } }

    private fun scan(scratch: Spans, counters: Counters.Builder, checkpoint: Checkpoint): Rows {
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
        bytes.addAndGet(HeapLayout.BAND_SPANS + ends.bytes + bounds.bytes)
        return Rows(rowStart, ends, bounds)
    }
}
