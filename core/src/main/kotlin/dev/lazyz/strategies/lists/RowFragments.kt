package dev.lazyz.strategies.lists

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.forEachKey

/**
 * The fragments of one row as visibility keys grouped by column, one piece of the row at a time.
 *
 * A fragment takes 8 bytes: its key holds depth and primitive, which together with the sample represent the suspended
 * colour. Fragments are grouped with a counting sort: the spans determine in advance how many fragments each column
 * gets.
 */
internal class RowFragments(private val frame: Frame, private val counters: Counters.Builder) {
    private val first = frame.region.columnStart
    private val width = frame.width
    private val test = frame.raster.depthTest
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)

    /** The row's spans: primitive, first column, column after the last. Columns are relative to the region's first. */
    private var spans = IntArray(3 * INITIAL)
    private var spanCount = 0

    /** For each column, the number of spans that cover it minus the number that cover the column before. */
    private val changes = IntArray(width + 1)
    private var covering = 0

    private val starts = IntArray(width)
    private val ends = IntArray(width)

    /** The fragments of the piece, grouped by column. */
    var keys: LongArray = LongArray(INITIAL)
        private set

    /** Bytes held; the arrays never shrink. */
    val peakBytes: Long get() = spans.bytes + changes.bytes + starts.bytes + ends.bytes + keys.bytes

    /** Index within [keys] of the first fragment of a column of the piece. */
    fun start(column: Int): Int = starts[column]

    /** Index within [keys] after the last fragment of a column of the piece. */
    fun end(column: Int): Int = ends[column]

    /** Begins a row. */
    fun clear() {
        spanCount = 0
        covering = 0
        changes.fill(0)
    }

    /** Adds a span of the primitive [index]: raster columns [from] until [until], within the region. */
    fun add(index: Int, from: Int, until: Int) {
        val at = 3 * spanCount++
        if (at == spans.size) spans = spans.copyOf(2 * at)
        spans[at] = index
        spans[at + 1] = from - first
        spans[at + 2] = until - first
        changes[from - first]++
        changes[until - first]--
    }

    /**
     * Collects the fragments of row [y] from column [from] on, for as many columns as fit into [AT_ONCE] fragments, but
     * at least one. Pieces must be requested from left to right. Returns the column after the piece.
     */
    fun fill(y: Int, from: Int): Int {
        // Determine where each column's fragments start
        var total = 0
        var until = from
        while (until < width) {
            val count = covering + changes[until]
            if (until > from && total > AT_ONCE - count) break
            covering = count
            starts[until] = total
            ends[until] = total
            total += count
            until++
        }
        if (total > keys.size) {
            // Release the old array before allocating the new one: its contents are not needed
            val size = maxOf(total, minOf(2 * keys.size, AT_ONCE))
            keys = LongArray(0)
            keys = LongArray(size)
        }

        // Walk the spans
        for (i in 0 until spanCount) {
            endIfInterrupted()
            val start = maxOf(spans[3 * i + 1], from)
            val end = minOf(spans[3 * i + 2], until)
            if (start < end) walk(spans[3 * i], y, start, end)
        }
        var held = 0L
        for (column in from until until) held += ends[column] - starts[column]
        counters.peakSuspensions = maxOf(counters.peakSuspensions, held)
        return until
    }

    private fun walk(index: Int, y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        counters.depthEvaluations += end - start
        frame.primitives[index].forEachKey(index, test, y, first + start, first + end) { x, key ->
            // Fragments behind the background are dropped
            if (key < backgroundKey) keys[ends[x - first]++] = key
        }
    }

    companion object {
        /** Most fragments held at once, unless a single sample has more: 8 megabytes. */
        const val AT_ONCE: Int = 1 shl 20

        private const val INITIAL = 64
    }
}
