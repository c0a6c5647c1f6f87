package dev.lazyz.conformance.strangers3

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Spans

/** Takes a finished sample. */
internal fun interface SampleSink {
    fun sample(x: Int, y: Int, argb: Int, depth: Int, primitive: Int)
}

/** What a thread needs for one tile: a key for each sample, and a list of translucent fragments. */
internal class TileScratch(private val side: Int, private val fragment: Fragment, private val mistake: Mistake?) {
    val counters = Counters.Builder()
    private val keys = LongArray(side * side)
    private val heads = IntArray(side * side)
    private var next = IntArray(64)
    private var waiting = LongArray(64)
    private var count = 0
    private var sorted = LongArray(16)
    private val over = Over(mistake)

    private lateinit var frame: Frame
    private lateinit var spans: Spans
    private lateinit var test: DepthTest
    private var left = 0
    private var top = 0
    private var right = 0
    private var bottom = 0
    private var suspended = 0L

    val bytes: Long get() = 12L * side * side + 12L * next.size + 8L * sorted.size + 128

    fun begin(frame: Frame, left: Int, top: Int, right: Int, bottom: Int) {
        this.frame = frame
        this.left = left
        this.top = top
        this.right = right
        this.bottom = bottom
        test = frame.raster.depthTest
        spans = Spans(left, right)
        keys.fill(frame.backgroundKey)
        heads.fill(-1)
        count = 0
        if (mistake != Mistake.TILES_PEAK_BY_WORKER) suspended = 0
    }

    fun draw(index: Int) {
        val primitive = frame.primitives[index]
        if (primitive.columnStart >= right || primitive.columnEnd <= left) return
        val from = maxOf(primitive.rowStart, top)
        val until = minOf(primitive.rowEnd, bottom)
        if (from >= until) return
        val cursor = primitive.cursor(from)
        for (y in from until until) {
            cursor.next(spans)
            for (i in 0 until spans.count) {
                for (x in spans.start(i) until spans.end(i)) sample(primitive, index, x, y)
            }
        }
    }

    private fun sample(primitive: Primitive, index: Int, x: Int, y: Int) {
        counters.fragments++
        counters.depthEvaluations++
        val at = (y - top) * side + x - left
        val depth = primitive.depthAt(x, y)
        val key = test.key(depth, index)
        if (primitive.isTranslucent) {
            val isBehind = key >= keys[at] || (mistake == Mistake.TILES_TIE_DROPPED && depth == test.depthOf(keys[at]))
            if (!isBehind) wait(at, key)
        } else if (key < keys[at]) {
            counters.depthPasses++
            keys[at] = key
        }
    }

    private fun wait(at: Int, key: Long) {
        if (count == next.size) {
            next = next.copyOf(2 * count)
            waiting = waiting.copyOf(2 * count)
        }
        waiting[count] = key
        next[count] = heads[at]
        heads[at] = count++
    }

    /** Finishes all samples of the tile. */
    fun finish(sink: SampleSink) {
        for (y in top until bottom) {
            for (x in left until right) {
                val at = (y - top) * side + x - left
                val key = keys[at]
                val kept = gather(at, key)
                if (kept == 0) {
                    sink.sample(x, y, plain(key, x, y), test.depthOf(key), test.indexOf(key))
                } else {
                    blend(kept, key, x, y, sink)
                }
            }
        }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, suspended)
    }

    /** Sorts the translucent fragments that are before [limit]; returns how many there are. */
    private fun gather(at: Int, limit: Long): Int {
        var kept = 0
        var i = heads[at]
        while (i >= 0) {
            if (waiting[i] < limit) {
                if (kept == sorted.size) sorted = sorted.copyOf(2 * kept)
                sorted[kept++] = waiting[i]
            }
            i = next[i]
        }
        if (mistake == Mistake.TILES_SORTS_DEPTH) {
            val order = sorted.take(kept).sortedWith(compareBy({ it shr 32 }, { test.indexOf(it) }))
            for (k in 0 until kept) sorted[k] = order[k]
        } else {
            sorted.sort(0, kept)
        }
        return kept
    }

    private fun plain(key: Long, x: Int, y: Int): Int {
        val index = test.indexOf(key)
        if (index == DepthTest.BACKGROUND) return frame.raster.background.toArgb()
        suspended++
        return shade(index, x, y).toArgb()
    }

    private fun blend(kept: Int, key: Long, x: Int, y: Int, sink: SampleSink) {
        suspended++
        counters.depthPasses++
        over.begin()
        var shown = sorted[0]
        var i = 0
        while (i < kept && over.isOpen) {
            val one = shade(test.indexOf(sorted[i]), x, y)
            if (mistake == Mistake.TILES_DEPTH_SKIPS_CLEAR && !(one.alpha > 0f) && shown == sorted[i]) {
                shown = if (i + 1 < kept) sorted[i + 1] else key
            }
            over.add(one)
            i++
        }
        val index = test.indexOf(key)
        if (over.isOpen && index != DepthTest.BACKGROUND) {
            over.end(shade(index, x, y))
        } else {
            over.end(frame.raster.background)
        }
        sink.sample(x, y, over.color.toArgb(), test.depthOf(shown), test.indexOf(shown))
    }

    private fun shade(index: Int, x: Int, y: Int): Fragment {
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        return fragment
    }
}
