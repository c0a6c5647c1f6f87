package dev.lazyz.conformance.strangers3

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Spans

/** A few rows, and the spans of what may be seen there. */
internal class ColumnBand(
    private val frame: Frame,
    private val rows: Int,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) {
    private val region = frame.region
    private val width = frame.width
    private val test = frame.raster.depthTest
    private val isReversed = test.key(1, 0) < test.key(0, 0)
    private val size = rows * width
    private val argb = IntArray(size)
    private val keys = LongArray(size)
    private val fragment = Fragment()
    private val spans = Spans(region)
    private val background = background()

    private var order = IntArray(0)
    private var values = IntArray(64)
    private var used = 0

    /** Where the spans of a place and row begin. */
    private var offsets = IntArray(0)

    var top = 0
        private set
    private var end = 0

    val bytes: Long get() = 12L * size

    val spanBytes: Long get() = 4L * (values.size + offsets.size + order.size) + 256

    private fun background(): Int {
        val color = frame.raster.background
        return (if (mistake == Mistake.COLUMNS_OPAQUE_PAPER) color.withAlpha(1f) else color).toArgb()
    }

    fun begin(top: Int, end: Int, order: IntArray) {
        this.top = top
        this.end = end
        this.order = order
        used = 0
        offsets = IntArray(order.size * (rows + 1) + 1)
    }

    /** A key that nothing of the primitive is before. */
    fun nearest(index: Int): Long {
        val primitive = frame.primitives[index]
        val isGreatest = isReversed && mistake != Mistake.COLUMNS_BOUND_SIDE
        return test.key(if (isGreatest) primitive.greatestDepth else primitive.leastDepth, index)
    }

    fun start(place: Int): Int = frame.primitives[order[place]].columnStart

    fun end(place: Int): Int = frame.primitives[order[place]].columnEnd

    /** Asks the primitive at [place] for its spans. */
    fun gather(place: Int, primitive: Primitive) {
        val from = place * (rows + 1)
        val first = maxOf(top, primitive.rowStart)
        val last = minOf(end, primitive.rowEnd)
        val cursor = if (first < last) primitive.cursor(first) else null
        for (y in top until end) {
            offsets[from + y - top] = used
            if (cursor == null || y < first || y >= last) continue
            cursor.next(spans)
            for (i in 0 until spans.count) {
                if (used + 2 > values.size) values = values.copyOf(2 * values.size)
                values[used++] = spans.start(i)
                values[used++] = spans.end(i)
            }
        }
        for (r in end - top..rows) offsets[from + r] = used
    }

    fun clear(start: Int, end: Int) {
        val empty = frame.backgroundKey
        for (r in 0 until this.end - top) {
            val at = r * width - region.columnStart
            keys.fill(empty, at + start, at + end)
            argb.fill(background, at + start, at + end)
        }
    }

    /** Draws a block of columns from near to far, then shades it. */
    fun block(start: Int, end: Int, places: IntArray) {
        clear(start, end)
        val samples = (end - start) * (this.end - top)
        var filled = 0
        for (place in places) {
            if (filled >= samples && isHidden(place, farthest(start, end))) continue
            for (r in 0 until this.end - top) filled += draw(place, r, start, end)
            if (filled >= samples && mistake == Mistake.COLUMNS_SHADES_WHEN_FULL) shade(start, end)
        }
        val visible = shade(start, end)
        counters.peakSuspensions = maxOf(counters.peakSuspensions, visible)
    }

    private fun isHidden(place: Int, farthest: Long): Boolean {
        val nearest = nearest(order[place])
        if (mistake == Mistake.COLUMNS_REJECTS_TIES) return nearest shr 32 >= farthest shr 32
        return nearest > farthest
    }

    private fun farthest(start: Int, end: Int): Long {
        var most = 0L
        for (r in 0 until this.end - top) {
            for (x in start until end) {
                val key = keys[r * width + x - region.columnStart]
                if (mistake == Mistake.COLUMNS_FULL_TWICE && test.indexOf(key) == DepthTest.BACKGROUND) continue
                most = maxOf(most, key)
            }
        }
        return most
    }

    /** Draws one row of a place; returns how many samples were background before. */
    private fun draw(place: Int, r: Int, start: Int, end: Int): Int {
        val at = place * (rows + 1) + r
        val primitive = frame.primitives[order[place]]
        var filled = 0
        var i = offsets[at]
        while (i < offsets[at + 1] && values[i] < end) {
            val from = maxOf(values[i], start)
            val until = minOf(values[i + 1], end)
            val whole = if (mistake == Mistake.COLUMNS_COUNTS_SPANS && from < until) values[i + 1] - values[i] else 0
            counters.fragments += maxOf(whole, until - from, 0)
            for (x in from until until) filled += sample(primitive, order[place], x, r)
            i += 2
        }
        return filled
    }

    private fun sample(primitive: Primitive, index: Int, x: Int, r: Int): Int {
        counters.depthEvaluations++
        val key = test.key(primitive.depthAt(x, top + r), index)
        val at = r * width + x - region.columnStart
        val old = keys[at]
        if (key >= old) return 0
        counters.depthPasses++
        keys[at] = key
        return if (mistake == Mistake.COLUMNS_FULL_TWICE || test.indexOf(old) == DepthTest.BACKGROUND) 1 else 0
    }

    private fun shade(start: Int, end: Int): Long {
        var visible = 0L
        for (r in 0 until this.end - top) {
            for (x in start until end) {
                val at = r * width + x - region.columnStart
                val index = test.indexOf(keys[at])
                if (index == DepthTest.BACKGROUND) continue
                visible++
                argb[at] = shade(if (mistake == Mistake.COLUMNS_SHORT_X) x and 0xFFFF else x, top + r, index)
            }
        }
        return visible
    }

    private fun shade(x: Int, y: Int, index: Int): Int {
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        return fragment.toArgb()
    }

    fun copyRow(r: Int, out: OutRow) {
        argb.copyInto(out.argb, 0, r * width, (r + 1) * width)
        for (i in 0 until width) {
            val key = keys[r * width + i]
            out.primitive[i] = test.indexOf(key)
            out.depth[i] = test.depthOf(key)
            if (out.primitive[i] < 0 && mistake == Mistake.COLUMNS_FAR_PAPER) {
                out.depth[i] = frame.raster.convention.farthest
            }
        }
    }
}
