package dev.lazyz.conformance.strangers5

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Spans

/** A row's spans in a segment tree over its columns. */
internal class CasterSpans(
    private val frame: Frame,
    private val counters: Counters.Builder,
    private val mistake: Mistake?
) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val leaves = when {
        region.width > 1 -> 2 * Integer.highestOneBit(region.width - 1)
        mistake == Mistake.CASTER_ONE_COLUMN -> 0
        else -> 1
    }
    private val heads = IntArray(2 * maxOf(1, leaves))
    private val spans = Spans(region)
    private var y = 0

    /** Links of lists: a span and the next link. */
    private var links = IntArray(64)
    private var linkCount = 0

    /** Of each span: the bound of its primitive, the form's value at the region's first column, and its step. */
    private var near = LongArray(16)
    private var values = LongArray(16)
    private var steps = LongArray(16)
    private var isCurved = BooleanArray(16)
    private var count = 0

    /** The keys of the last [gather]. */
    var keys: LongArray = LongArray(16)
        private set

    /** Bytes held. */
    val bytes: Long get() = 4L * heads.size + 4L * links.size + 25L * near.size + 8L * keys.size

    /** Takes the spans of row [y] of all that is [active]. */
    fun fill(y: Int, active: CasterActive) {
        this.y = y
        heads.fill(-1)
        linkCount = 0
        count = 0

        // From far to near, because lists grow at their heads
        for (i in active.count - 1 downTo 0) {
            val primitive = active.primitive(i)
            active.cursor(i).next(spans)
            if (spans.count == 0) continue
            val form = primitive.depthForm
            val isLevel = mistake == Mistake.CASTER_LEVEL_CACHE && form != null && form.dx == 0L
            val value = if (isLevel) active.level(i) else form?.at(region.columnStart, y) ?: 0L
            val span = open(active.near[i], value, form?.dx ?: 0L, form == null)
            for (k in 0 until spans.count) {
                if (mistake == Mistake.CASTER_FOUR_SPANS && k == 3) {
                    insert(spans.start(k) - region.columnStart, spans.end(spans.count - 1) - region.columnStart, span)
                    break
                }
                insert(spans.start(k) - region.columnStart, spans.end(k) - region.columnStart, span)
            }
        }
    }

    private fun open(bound: Long, value: Long, step: Long, curved: Boolean): Int {
        if (count == near.size) {
            near = near.copyOf(2 * count)
            values = values.copyOf(2 * count)
            steps = steps.copyOf(2 * count)
            isCurved = isCurved.copyOf(2 * count)
        }
        near[count] = bound
        values[count] = value
        steps[count] = step
        isCurved[count] = curved
        return count++
    }

    private fun insert(from: Int, until: Int, span: Int) {
        counters.fragments += until - from
        val isShort = mistake == Mistake.CASTER_SHORT_COLUMNS
        var left = leaves + if (isShort) from and 0xFFFF else from
        var right = leaves + if (isShort) until and 0xFFFF else until
        while (left < right) {
            if (left and 1 == 1) hang(left++, span)
            if (right and 1 == 1) hang(--right, span)
            left = left ushr 1
            right = right ushr 1
        }
    }

    private fun hang(node: Int, span: Int) {
        if (2 * linkCount == links.size) links = links.copyOf(4 * linkCount)
        links[2 * linkCount] = span
        links[2 * linkCount + 1] = heads[node]
        heads[node] = linkCount++
    }

    private fun key(span: Int, column: Int): Long {
        counters.depthEvaluations++
        val index = test.indexOf(near[span])
        val depth = if (isCurved[span]) {
            frame.primitives[index].depth(region.columnStart + column, y)
        } else {
            (values[span] + steps[span] * column shr 32).toInt()
        }
        return test.key(depth, index)
    }

    /** Returns the key of what is visible at a [column] of the region. */
    fun nearest(column: Int): Long {
        var best = background
        var node = column + leaves
        while (node > 0) {
            var link = heads[node]
            while (link >= 0) {
                val span = links[2 * link]
                if (mistake == Mistake.CASTER_EARLY_OUT_TIE) {
                    if (near[span] ushr 32 >= best ushr 32) break
                } else if (near[span] > best) {
                    break
                }
                val key = key(span, column)
                if (key < best) {
                    best = key
                    counters.depthPasses++
                }
                link = links[2 * link + 1]
            }
            node = node ushr 1
        }
        return best
    }

    /** Puts the keys of all fragments at a [column] into [keys], in order, and returns their number. */
    fun gather(column: Int): Int {
        var size = 0
        var node = column + leaves
        while (node > 0) {
            var link = heads[node]
            while (link >= 0) {
                val key = key(links[2 * link], column)
                if (key < background || mistake == Mistake.CASTER_CELL_BEHIND) {
                    if (size == keys.size) keys = keys.copyOf(2 * size)
                    keys[size++] = key
                }
                link = links[2 * link + 1]
            }
            node = node ushr 1
        }
        sort(size)
        if (size > 0) counters.depthPasses++
        counters.peakSuspensions = maxOf(counters.peakSuspensions, size.toLong())
        return size
    }

    private fun sort(size: Int) {
        keys.sort(0, size)
        if (mistake != Mistake.CASTER_CELL_TIES) return
        var i = 0
        while (i < size) {
            var end = i + 1
            while (end < size && keys[end] ushr 32 == keys[i] ushr 32) end++
            if (end - i > 1 && test.indexOf(keys[i]) > test.indexOf(keys[i + 1])) keys.reverse(i, end)
            i = end
        }
    }
}
