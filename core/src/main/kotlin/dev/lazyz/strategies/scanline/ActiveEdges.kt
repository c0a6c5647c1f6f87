package dev.lazyz.strategies.scanline

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.byFirstRow
import dev.lazyz.raster.sortKeys
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

/**
 * The active edge list: the ends of all spans of the current row, in order of columns.
 *
 * A span keeps its number from row to row as long as its primitive has the same number of spans. Its two edges
 * therefore keep their places in the list, and sorting only has to correct what has changed. A primitive's own cursor
 * steps its edges, with exact increments if the primitive is a polygon. Span 0 is the background: it is as wide as the
 * region, and has no edges and no cursor.
 *
 * Source: Chris Wylie, Gordon Romney, David Evans, Alan Erdahl, "Half-tone perspective drawings by computer" (1967). In
 * the paper, a table has a bucket of edges for each row; here waiting primitives are sorted by first row, which takes
 * no memory for rows.
 */
internal class ActiveEdges(private val frame: Frame, private val counters: Counters.Builder) {
    private val region = frame.region

    /**
     * The edge table: primitives that are not yet active, with the first row in the upper half and the index in the
     * lower half, ascending.
     */
    private val waiting = frame.byFirstRow(Checkpoint.CALLER)
    private var entered = 0

    /** A primitive that the current row may intersect, and the numbers of its spans. */
    private class Active(val primitive: Int, val rowEnd: Int, val cursor: SpanCursor) {
        var spans = IntArray(1)
        var count = 0
    }

    private var actives = arrayOfNulls<Active>(INITIAL)
    private var activeCount = 0
    private val row = region.spans()

    /**
     * For each span, the first column, the column after the last (0 if the number is not in use), and the primitive.
     */
    private var starts = IntArray(INITIAL)
    private var ends = IntArray(INITIAL)
    private var primitives = IntArray(INITIAL)
    private var numbers = 1
    private var free = IntArray(INITIAL)
    private var freeCount = 0

    /** The list: the column in the upper half; in the lower half twice the span, plus one for the edge at its end. */
    private var edges = LongArray(INITIAL)

    /** Number of edges. */
    var count: Int = 0
        private set

    init {
        starts[BACKGROUND_SPAN] = region.columnStart
        ends[BACKGROUND_SPAN] = region.columnEnd
        primitives[BACKGROUND_SPAN] = -1
    }

    /** Exclusive upper bound of span numbers. */
    val spanLimit: Int get() = starts.size

    /**
     * Bytes currently held. A cursor belongs to its primitive; its size is estimated as that of a triangle's cursor.
     */
    val bytes: Long
        get() = waiting.bytes + edges.bytes + actives.bytes + starts.bytes + ends.bytes + primitives.bytes +
            free.bytes + HeapLayout.ACTIVE_PRIMITIVE * activeCount

    /** Column of edge [i]. */
    fun column(i: Int): Int = (edges[i] shr 32).toInt()

    /** The span that starts or ends at edge [i]. */
    fun span(i: Int): Int = edges[i].toInt() ushr 1

    /** Whether edge [i] is the start of its span. */
    fun isStart(i: Int): Boolean = edges[i] and 1L == 0L

    /** The column after the last of [span]. */
    fun end(span: Int): Int = ends[span]

    /** The submission index of the primitive that [span] belongs to. */
    fun primitive(span: Int): Int = primitives[span]

    /** Moves to row [y]; must be called for each row of the region, in order. */
    fun moveTo(y: Int) {
        // Add primitives at their first row
        while (entered < waiting.size && (waiting[entered] shr 32).toInt() == y) enter(waiting[entered++].toInt(), y)

        // Remove primitives that have ended, step the others
        var kept = 0
        for (i in 0 until activeCount) {
            endIfInterrupted()
            val active = actives[i]!!
            row.clear()
            if (y < active.rowEnd) active.cursor.next(row)
            place(active)
            if (y < active.rowEnd) actives[kept++] = active
        }
        actives.fill(null, kept, activeCount)
        activeCount = kept

        // Update the columns of the edges, and sort them
        renew()
        sort()
    }

    private fun enter(index: Int, y: Int) {
        if (activeCount == actives.size) actives = actives.copyOf(2 * activeCount)
        val primitive = frame.primitives[index]
        actives[activeCount++] = Active(index, primitive.rowEnd, primitive.cursor(y))
    }

    /** Assigns numbers to the primitive's spans of this row, reusing those of the last row where possible. */
    private fun place(active: Active) {
        while (active.count > row.count) ends[active.spans[--active.count]] = UNUSED
        while (active.count < row.count) {
            if (active.count == active.spans.size) active.spans = active.spans.copyOf(2 * active.count)
            active.spans[active.count++] = number(active.primitive)
        }
        for (i in 0 until row.count) {
            val span = active.spans[i]
            starts[span] = row.start(i)
            ends[span] = row.end(i)
            counters.fragments += row.end(i) - row.start(i)
        }
    }

    /** Returns a number for a new span, and appends its edges to the list, unsorted. */
    private fun number(primitive: Int): Int {
        if (freeCount == 0 && numbers == starts.size) {
            starts = starts.copyOf(2 * numbers)
            ends = ends.copyOf(2 * numbers)
            primitives = primitives.copyOf(2 * numbers)
            free = free.copyOf(2 * numbers)
        }
        val span = if (freeCount > 0) free[--freeCount] else numbers++
        primitives[span] = primitive
        if (count + 2 > edges.size) edges = edges.copyOf(2 * edges.size)
        edges[count++] = 2L * span
        edges[count++] = 2L * span + 1
        return span
    }

    /** Updates the columns of the edges for this row. The numbers of spans that have ended become free. */
    private fun renew() {
        var kept = 0
        for (i in 0 until count) {
            val span = span(i)
            val column = if (isStart(i)) starts[span] else ends[span]
            if (ends[span] != UNUSED) {
                edges[kept++] = column.toLong() shl 32 or (edges[i] and LOWER_HALF)
            } else if (isStart(i)) {
                free[freeCount++] = span
            }
        }
        count = kept
    }

    /** Insertion sort: few edges change places from one row to the next. If many do, sorts from scratch. */
    private fun sort() {
        var moves = 0L
        for (i in 1 until count) {
            val edge = edges[i]
            var at = i
            while (at > 0 && edges[at - 1] > edge) {
                edges[at] = edges[at - 1]
                at--
            }
            edges[at] = edge
            moves += i - at
            if (moves > MOVES_PER_EDGE * count) {
                edges.sortKeys(Checkpoint.CALLER, 0, count)
                return
            }
        }
    }

    companion object {
        /** The span of the background. */
        const val BACKGROUND_SPAN: Int = 0

        private const val UNUSED = 0
        private const val INITIAL = 16
        private const val LOWER_HALF = 0xFFFFFFFFL

        /**
         * Average number of moves an edge after which sorting from scratch is cheaper than continuing the insertion
         * sort.
         */
        private const val MOVES_PER_EDGE = 8L
    }
}
