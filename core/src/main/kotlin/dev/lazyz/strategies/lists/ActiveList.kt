package dev.lazyz.strategies.lists

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.byFirstRow

/**
 * The primitives that may cover the current row, each with a cursor. A primitive is added at its first row and removed
 * after its last. The order does not matter, because the fragments of a sample are sorted by key.
 */
internal class ActiveList(private val frame: Frame) {
    private val spans = Spans(frame.region)

    /** First row and index of each primitive that may cover the region, sorted. */
    private val arrivals = frame.byFirstRow(Checkpoint.CALLER)
    private var arrived = 0

    private var indices = IntArray(INITIAL)
    private var cursors = arrayOfNulls<SpanCursor>(INITIAL)
    private var count = 0

    /** Bytes held; the arrays never shrink. */
    val peakBytes: Long get() = arrivals.bytes + indices.bytes + cursors.bytes

    /** Adds the spans of row [y], which follows the row of the last call, to [fragments]. */
    fun moveTo(y: Int, fragments: RowFragments) {
        // Add the primitives that start at this row
        while (arrived < arrivals.size && (arrivals[arrived] ushr 32).toInt() == y) {
            admit(arrivals[arrived++].toInt(), y)
        }

        // Get the spans of each primitive, and remove primitives that end at this row
        fragments.clear()
        var i = 0
        while (i < count) {
            endIfInterrupted()
            val index = indices[i]
            checkNotNull(cursors[i]).next(spans)
            for (span in 0 until spans.count) fragments.add(index, spans.start(span), spans.end(span))
            if (y + 1 < frame.primitives[index].rowEnd) i++ else dismiss(i)
        }
    }

    private fun admit(index: Int, y: Int) {
        if (count == indices.size) {
            indices = indices.copyOf(2 * count)
            cursors = cursors.copyOf(2 * count)
        }
        indices[count] = index
        cursors[count] = frame.primitives[index].cursor(y)
        count++
    }

    private fun dismiss(i: Int) {
        count--
        indices[i] = indices[count]
        cursors[i] = cursors[count]
        cursors[count] = null
    }

    private companion object {
        const val INITIAL = 16
    }
}
