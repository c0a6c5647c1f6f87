package dev.lazyz.conformance.strangers4

import dev.lazyz.Frame
import dev.lazyz.SpanCursor
import dev.lazyz.Spans

/** The primitives that the current row cuts, and the spans that they have there. */
internal class SweepList(private val frame: Frame, private val mistake: Mistake?) {
    private val region = frame.region
    private val spans = Spans(region)

    /** First row and index of the primitives that are to come, sorted. */
    private val arrivals: LongArray
    private var arrived = 0

    /** For each row where its arrivals begin, as textbooks have it. */
    private val buckets: IntArray

    private var indices = IntArray(16)
    private var cursors = arrayOfNulls<SpanCursor>(16)
    private var active = 0

    /** Spans of the row: primitive, first column, column after the last. */
    private var row = IntArray(48)

    var count: Int = 0
        private set

    init {
        val touching = frame.primitives.indices.filter { frame.primitives[it].touches(region) }
        arrivals = LongArray(touching.size) { firstRow(touching[it]).toLong() shl 32 or touching[it].toLong() }
        arrivals.sort()
        buckets = if (mistake == Mistake.SWEEP_ROW_TABLE) IntArray(region.height + 1) else IntArray(0)
    }

    /** Number of primitives that reach into the region. */
    val reaching: Int get() = arrivals.size

    val bytes: Long get() = 8L * arrivals.size + 4L * (buckets.size + row.size) + 12L * indices.size

    fun index(span: Int): Int = row[3 * span]

    fun start(span: Int): Int = row[3 * span + 1]

    fun end(span: Int): Int = row[3 * span + 2]

    /** Goes to row [y], the next one, and gathers its spans. */
    fun moveTo(y: Int) {
        admit(y)
        count = 0
        var i = 0
        while (i < active) {
            checkNotNull(cursors[i]).next(spans)
            for (span in 0 until spans.count) add(indices[i], spans.start(span), spans.end(span))
            if (y + 1 < frame.primitives[indices[i]].rowEnd) {
                i++
            } else {
                active--
                indices[i] = indices[active]
                cursors[i] = cursors[active]
                cursors[active] = null
            }
        }
    }

    /** Lets in the primitives whose first row is [y]. */
    fun admit(y: Int) {
        if (buckets.isNotEmpty() && y < region.rowEnd) buckets[y - region.rowStart] = arrived
        while (arrived < arrivals.size && (arrivals[arrived] ushr 32).toInt() <= y) {
            val index = arrivals[arrived].toInt()
            if (mistake == Mistake.SWEEP_BEGUN_ABOVE && frame.primitives[index].rowStart != y) {
                arrived++
                continue
            }
            if (active == indices.size) {
                indices = indices.copyOf(2 * active)
                cursors = cursors.copyOf(2 * active)
            }
            val from = if (mistake == Mistake.SWEEP_CURSOR_FROM_TOP) frame.primitives[index].rowStart else y
            indices[active] = index
            cursors[active++] = frame.primitives[index].cursor(from)
            arrived++
        }
    }

    private fun firstRow(index: Int): Int = maxOf(frame.primitives[index].rowStart, region.rowStart)

    private fun add(index: Int, start: Int, end: Int) {
        if (3 * count == row.size) row = row.copyOf(2 * row.size)
        row[3 * count] = index
        row[3 * count + 1] = start
        row[3 * count + 2] = end
        count++
    }
}
