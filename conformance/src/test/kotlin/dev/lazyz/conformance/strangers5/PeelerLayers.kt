package dev.lazyz.conformance.strangers5

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Spans

/** Peels the layers of one piece of the image after the other; a piece has [length] samples, in rows from the top. */
internal class PeelerLayers(
    private val frame: Frame,
    private val image: PeelerImage,
    length: Int,
    private val mistake: Mistake?,
) {
    private val region = frame.region
    private val width = region.width
    private val test = frame.raster.depthTest
    private val rows = PeelerRows(frame, mistake)
    private val mixer = Mixer(mistake)

    /** Of each sample the keys of the nearest layer, of the last one and of the next one, and its sums. */
    private val nearest = LongArray(length)
    private val last = LongArray(length)
    private val next = LongArray(length)
    private val sums = FloatArray(Mixer.STATE * length)

    /** Colours the samples [start] until [end]. */
    fun peel(start: Int, end: Int) {
        nearest.fill(NONE)
        last.fill(-1)
        mixer.begin()
        for (i in 0 until end - start) mixer.save(sums, Mixer.STATE * i)
        var layer = 0
        while (find(start, end, layer == 0)) {
            for (i in 0 until end - start) if (next[i] != NONE) add(start, i)
            layer++
        }
        for (i in 0 until end - start) {
            if (nearest[i] == NONE) image.color(start + i) else finish(start, i)
        }
    }

    /** Finds the next layer; returns whether there is one. */
    private fun find(start: Int, end: Int, isFirst: Boolean): Boolean {
        next.fill(NONE)
        var found = false
        val counters = image.counters
        val top = region.rowStart + start / width
        val bottom = region.rowStart + (end - 1) / width
        val lastEnd = region.columnStart + (end - 1) % width + 1
        for ((index, primitive) in frame.primitives.withIndex()) {
            image.checkInterrupt()
            if (!primitive.meets(region) || !primitive.isTranslucent) continue
            for (y in maxOf(primitive.rowStart, top)..minOf(primitive.rowEnd - 1, bottom)) {
                val from = if (y == top) region.columnStart + start % width else region.columnStart
                val isCut = y == bottom || mistake == Mistake.PEELER_PIECE_END
                val until = if (isCut) lastEnd else region.columnEnd
                rows.forEach(primitive, y, from, until) { x, depth ->
                    val at = (y - region.rowStart) * width + x - region.columnStart
                    val i = at - start
                    val key = test.key(depth, index)
                    counters.depthEvaluations++
                    if (isFirst || mistake == Mistake.PEELER_FRAGMENTS) counters.fragments++
                    val isBehind = if (mistake == Mistake.PEELER_STRICT_DEPTH) {
                        last[i] < 0 || key ushr 32 > last[i] ushr 32
                    } else {
                        key > last[i]
                    }
                    if (isBehind && key < next[i] && key < image.key(at)) {
                        next[i] = key
                        found = true
                        if (isFirst) counters.depthPasses++
                    }
                }
            }
        }
        return found
    }

    private fun add(start: Int, i: Int) {
        if (nearest[i] == NONE) nearest[i] = next[i]
        mixer.load(sums, Mixer.STATE * i)
        mixer.add(image.shade(start + i, test.indexOf(next[i])))
        mixer.save(sums, Mixer.STATE * i)

        // No fragment lies behind the greatest of keys
        last[i] = if (mixer.isOpen) next[i] else NONE
    }

    private fun finish(start: Int, i: Int) {
        val at = start + i
        mixer.load(sums, Mixer.STATE * i)
        val index = test.indexOf(image.key(at))
        val isSeen = mixer.isOpen || mistake == Mistake.PEELER_HIDDEN_BACKDROP
        val color = if (isSeen && index != DepthTest.BACKGROUND) {
            val backdrop = image.shade(at, index)
            mixer.finish(backdrop.red, backdrop.green, backdrop.blue, backdrop.alpha)
        } else {
            mixer.finish(frame.raster.background)
        }
        image.setColor(at, color)
        image.set(at, nearest[i])
    }

    companion object {
        /** Bytes for each sample of a piece. */
        const val BYTES: Long = 24L + 4L * Mixer.STATE
        private const val NONE = Long.MAX_VALUE
    }
}

/** The samples of a primitive on a row, with their depths. */
internal class PeelerRows(private val frame: Frame, private val mistake: Mistake?) {
    private val spans = Spans(frame.region)

    /** Calls [action] for the samples of row [y] from column [from] until column [until]. */
    inline fun forEach(primitive: Primitive, y: Int, from: Int, until: Int, action: (Int, Int) -> Unit) {
        val isBox = mistake == Mistake.PEELER_BOX && isBox(primitive)
        find(primitive, y, isBox)
        val form = primitive.depthForm
        for (k in 0 until spans.count) {
            val start = maxOf(spans.start(k), from)
            var value = form?.at(start, y) ?: 0L
            for (x in start until minOf(spans.end(k), until)) {
                val depth = when {
                    mistake == Mistake.PEELER_SINGLE_SAMPLE && isSingle(primitive) -> primitive.leastDepth
                    form != null -> (value shr 32).toInt()
                    else -> primitive.depth(x, y)
                }
                if (form != null) value += form.dx
                action(x, depth)
            }
        }
    }

    private fun find(primitive: Primitive, y: Int, isBox: Boolean) {
        spans.clear()
        if (isBox) spans.add(primitive.columnStart, primitive.columnEnd) else primitive.spans(y, spans)
    }

    private fun isSingle(primitive: Primitive): Boolean =
        primitive.columnEnd - primitive.columnStart == 1 && primitive.rowEnd - primitive.rowStart == 1

    private fun isBox(primitive: Primitive): Boolean = isFull(primitive, primitive.rowStart) &&
        isFull(primitive, primitive.rowEnd - 1)

    private fun isFull(primitive: Primitive, y: Int): Boolean {
        val all = Spans()
        primitive.spans(y, all)
        return all.count == 1 && all.start(0) == primitive.columnStart && all.end(0) == primitive.columnEnd
    }
}
