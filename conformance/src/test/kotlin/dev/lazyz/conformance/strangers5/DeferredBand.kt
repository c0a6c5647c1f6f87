package dev.lazyz.conformance.strangers5

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Spans

/** One thread's buffer for a band: a key of what is opaque for each sample, and lists of what is translucent. */
internal class DeferredBand(
    private val frame: Frame,
    private val bands: DeferredBands,
    private val mistake: Mistake?,
    private val isStopped: () -> Boolean,
) {
    private val region = frame.region
    private val width = region.width
    private val test = frame.raster.depthTest
    private val isReverse = test.isReverse()
    private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val keys = LongArray(width * bands.height)

    /** Of each sample the least key so far, translucent or not. */
    private val nearest = LongArray(keys.size)
    private val lists = DeferredLists(keys.size)
    private val spans = Spans(region)
    private val shading = DeferredShading(frame, lists, mistake)
    private var top = 0
    private var bottom = 0

    /** No key that is not less can be seen anywhere in the band. */
    private var farthest = 0L
    private var isHidden = false

    /** Bytes of lists. */
    val listBytes: Long get() = lists.bytes

    /** Renders a band and counts into [counters]; null if the rendering has been stopped. */
    fun render(number: Int, counters: Counters.Builder): DeferredResult? {
        top = region.rowStart + number * bands.height
        bottom = minOf(top + bands.height, region.rowEnd)
        keys.fill(background)
        nearest.fill(background)
        lists.clear()
        farthest = background
        isHidden = false
        for (i in bands.indices.indices) {
            if (isStopped()) return null
            if (bands.reaches(i, number)) draw(frame.primitives[bands.indices[i]], bands.indices[i], counters)
        }
        val result = DeferredResult(top, bottom - top, width * (bottom - top), counters)
        for (x in 0 until width) {
            if (isStopped()) return null
            shading.column(x, keys, result)
        }
        return result
    }

    /** Bounds of depth: exact for what is level, as walls are that face the viewer. */
    private fun least(primitive: Primitive): Int = level(primitive.depthForm) ?: primitive.leastDepth

    private fun greatest(primitive: Primitive): Int = level(primitive.depthForm) ?: primitive.greatestDepth

    private fun level(form: LinearForm?): Int? =
        if (form != null && form.dx == 0L && form.dy == 0L) (form.c shr 32).toInt() else null

    private fun draw(primitive: Primitive, index: Int, counters: Counters.Builder) {
        val bound = test.key(if (isReverse) greatest(primitive) else least(primitive), index)
        if (bound >= farthest) return
        if (mistake == Mistake.DEFERRED_OCCLUDER_TIE && isHidden && bound ushr 32 >= farthest ushr 32) return
        val isTranslucent = primitive.isTranslucent
        val from = maxOf(primitive.rowStart, top)
        val until = minOf(primitive.rowEnd, bottom)
        if (from >= until) return
        val cursor = primitive.cursor(from)
        val form = primitive.depthForm
        val whole = form?.dx ?: 0L
        val step = if (mistake == Mistake.DEFERRED_COARSE_STEP) whole shr 16 shl 16 else whole
        var isFull = !isTranslucent && from == top && until == bottom
        for (y in from until until) {
            cursor.next(spans)
            val isInner = mistake == Mistake.DEFERRED_OCCLUDER && y > top && y < bottom - 1
            if (!isInner &&
                (spans.count != 1 || spans.start(0) > region.columnStart || spans.end(0) < region.columnEnd)
            ) {
                isFull = false
            }
            for (i in 0 until spans.count) {
                val start = spans.start(i)
                var value = form?.at(start, y) ?: 0L
                counters.fragments += spans.end(i) - start
                counters.depthEvaluations += spans.end(i) - start
                for (x in start until spans.end(i)) {
                    val depth = if (form == null) primitive.depth(x, y) else (value shr 32).toInt()
                    value += step
                    put((y - top) * width + x - region.columnStart, test.key(depth, index), isTranslucent, counters)
                }
            }
        }
        if (!isFull) return
        isHidden = true
        val isLeast = isReverse && mistake != Mistake.DEFERRED_OCCLUDER_GREATEST
        val back = test.key(if (isLeast) least(primitive) else greatest(primitive), index)
        farthest = minOf(farthest, back + 1)
    }

    private fun put(at: Int, key: Long, isTranslucent: Boolean, counters: Counters.Builder) {
        if (key >= keys[at]) return
        if (key < nearest[at]) {
            nearest[at] = key
            counters.depthPasses++
        }
        if (!isTranslucent) {
            keys[at] = key
        } else if (mistake != Mistake.DEFERRED_SIXTEEN || lists.length(at) < 16) {
            lists.add(at, key)
        }
    }
}

/** Linked lists of translucent fragments, one a sample, out of one pool. */
internal class DeferredLists(samples: Int) {
    private val heads = IntArray(samples)
    private var nexts = IntArray(64)
    private var keys = LongArray(64)
    private var count = 0

    /** The keys of the last [gather]. */
    var gathered: LongArray = LongArray(16)
        private set

    /** Bytes held. */
    val bytes: Long get() = 12L * nexts.size + 8L * gathered.size

    /** Empties all lists. */
    fun clear() {
        heads.fill(-1)
        count = 0
    }

    /** Adds a fragment. */
    fun add(at: Int, key: Long) {
        if (count == nexts.size) {
            nexts = nexts.copyOf(2 * count)
            keys = keys.copyOf(2 * count)
        }
        keys[count] = key
        nexts[count] = heads[at]
        heads[at] = count++
    }

    /** Returns the number of fragments of a sample. */
    fun length(at: Int): Int {
        var length = 0
        var node = heads[at]
        while (node >= 0) {
            length++
            node = nexts[node]
        }
        return length
    }

    /**
     * Puts the fragments before [limit] into [gathered], ordered by what [rank] makes of them; returns their number.
     */
    inline fun gather(at: Int, limit: Long, rank: (Long) -> Long): Int {
        var size = 0
        var node = heads[at]
        while (node >= 0) {
            val key = keys[node]
            node = nexts[node]
            if (key >= limit) continue
            if (size == gathered.size) gathered = gathered.copyOf(2 * size)
            var place = size++
            while (place > 0 && rank(gathered[place - 1]) > rank(key)) {
                gathered[place] = gathered[place - 1]
                place--
            }
            gathered[place] = key
        }
        return size
    }
}
