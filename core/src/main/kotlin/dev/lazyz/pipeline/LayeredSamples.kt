package dev.lazyz.pipeline

import dev.lazyz.Blending
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachRow
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans

/**
 * For each sample of a region the nearest opaque fragment so far, and all translucent fragments in front of it, with
 * their colours. Primitives are drawn one at a time, in any order, and not kept.
 *
 * A translucent fragment is recorded unless it is behind an opaque one that came earlier. When the memory is used up,
 * those that later opaque fragments hide are removed.
 *
 * Memory: 28 bytes a sample, and 28 bytes a recorded fragment. Used by one thread.
 *
 * @param mostBytes most bytes to hold, unless the samples alone take more
 */
internal class LayeredSamples(
    private val raster: Raster,
    private val region: Region,
    mostBytes: Long,
    private val counters: Counters.Builder,
) {
    private val test = raster.depthTest
    private val background = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)
    private val size = region.size.toInt()

    /** Keys and colours of the nearest opaque fragments. */
    private val keys = LongArray(size) { background }
    private val colors = FloatArray(4 * size)

    /** The translucent fragments: a list for each sample. [heads] and [next] are numbers of fragments, or [NONE]. */
    private val heads = IntArray(size) { NONE }
    private var next = IntArray(0)
    private var layerKeys = LongArray(0)
    private var layerColors = FloatArray(0)
    private var count = 0
    private val mostLayers = ((mostBytes - BYTES_PER_SAMPLE * size) / BYTES_PER_LAYER).coerceIn(0, MOST_LAYERS).toInt()

    private val fragment = Fragment()
    private val spans = region.spans()

    /** Bytes held. */
    val bytes: Long get() = BYTES_PER_SAMPLE * size + BYTES_PER_LAYER * next.size

    /** Draws [primitive], whose submission index is [index]. Returns false if there is not enough memory. */
    fun draw(primitive: Primitive, index: Int): Boolean {
        primitive.forEachRow(region, spans) { y ->
            for (i in 0 until spans.count) {
                if (!drawSpan(primitive, index, y, spans.start(i), spans.end(i))) return false
            }
        }
        return true
    }

    private fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int): Boolean {
        counters.fragments += end - start
        counters.depthEvaluations += end - start
        val isTranslucent = primitive.isTranslucent
        var at = (y - region.rowStart) * region.width + (start - region.columnStart)
        primitive.forEachKey(index, test, y, start, end) { x, key ->
            if (key < keys[at]) {
                if (isTranslucent && !reserve()) return false
                endIfInterrupted()
                counters.depthPasses++
                counters.shadingCalls++
                fragment.moveTo(x, y)
                primitive.shade(fragment)
                if (isTranslucent) add(at, key) else replace(at, key)
            }
            at++
        }
        return true
    }

    private fun replace(at: Int, key: Long) {
        keys[at] = key
        store(fragment, colors, at)
    }

    private fun add(at: Int, key: Long) {
        layerKeys[count] = key
        store(fragment, layerColors, count)
        next[count] = heads[at]
        heads[at] = count++
    }

    /** Makes room for one more fragment. Returns false if there is none. */
    private fun reserve(): Boolean {
        if (count < next.size) return true
        if (next.size == mostLayers) {
            removeHidden()

            // With little room left, the next removal would follow too soon
            return count < mostLayers - mostLayers / 4
        }
        val room = minOf(maxOf(LEAST_LAYERS, next.size + next.size / 2), mostLayers)
        next = next.copyOf(room)
        layerKeys = layerKeys.copyOf(room)
        layerColors = layerColors.copyOf(4 * room)
        return true
    }

    /** Removes the fragments behind the nearest opaque ones. */
    private fun removeHidden() {
        // Note the sample of each fragment that stays, in the place of its successor
        for (at in 0 until size) {
            if (Checkpoint.isDue(at)) endIfInterrupted()
            var layer = heads[at]
            while (layer != NONE) {
                val following = next[layer]
                next[layer] = if (layerKeys[layer] < keys[at]) at else NONE
                layer = following
            }
        }
        heads.fill(NONE)
        val before = count
        count = 0
        for (layer in 0 until before) {
            if (Checkpoint.isDue(layer)) endIfInterrupted()
            val at = next[layer]
            if (at == NONE) continue
            layerKeys[count] = layerKeys[layer]
            layerColors.copyInto(layerColors, 4 * count, 4 * layer, 4 * layer + 4)
            next[count] = heads[at]
            heads[at] = count++
        }
    }

    /** Blends the fragments of each sample (contract rule 5.5), and passes every row to [sink], from top to bottom. */
    fun handOut(sink: RowSink) {
        val argb = IntArray(region.width)
        val depths = IntArray(region.width)
        val indices = IntArray(region.width)
        val blending = Blending()
        val layers = SortedLayers()
        for (row in 0 until region.height) {
            for (x in 0 until region.width) {
                endIfInterrupted()
                val at = row * region.width + x
                layers.collect(at)
                argb[x] = blending.blend(layers.count, keys[at] != background, raster.background) { number ->
                    if (number < layers.count) load(layerColors, layers.numbers[number]) else load(colors, at)
                }
                val key = if (layers.count > 0) layerKeys[layers.numbers[0]] else keys[at]
                depths[x] = test.depthOf(key)
                indices[x] = test.indexOf(key)
            }
            sink.row(region.rowStart + row, argb, depths, indices)
        }
    }

    private fun load(from: FloatArray, number: Int): Fragment {
        fragment.setColor(from[4 * number], from[4 * number + 1], from[4 * number + 2], from[4 * number + 3])
        return fragment
    }

    /** The visible fragments of one sample. */
    private inner class SortedLayers {
        /** Their numbers, from near to far; the first [count] are valid. */
        var numbers = IntArray(16)
        var count = 0

        fun collect(at: Int) {
            count = 0
            var layer = heads[at]
            while (layer != NONE) {
                if (layerKeys[layer] < keys[at]) {
                    if (count == numbers.size) numbers = numbers.copyOf(2 * count)
                    numbers[count++] = layer
                }
                layer = next[layer]
            }
            if (count > FEW) sort() else sortFew()
        }

        private fun sortFew() {
            for (i in 1 until count) {
                val layer = numbers[i]
                var to = i
                while (to > 0 && layerKeys[numbers[to - 1]] > layerKeys[layer]) {
                    numbers[to] = numbers[to - 1]
                    to--
                }
                numbers[to] = layer
            }
        }

        private fun sort() {
            numbers.take(count).sortedBy { layerKeys[it] }.forEachIndexed { i, layer -> numbers[i] = layer }
        }
    }

    companion object {
        /** Bytes of a sample without translucent fragments. */
        const val BYTES_PER_SAMPLE: Long = 28

        /** Bytes of a translucent fragment. */
        const val BYTES_PER_LAYER: Long = 28
        private const val NONE = -1
        private const val LEAST_LAYERS = 1024
        private const val MOST_LAYERS = (1L shl 29) - 8

        /** Up to this many fragments are sorted by insertion. */
        private const val FEW = 48

        private fun store(fragment: Fragment, to: FloatArray, number: Int) {
            to[4 * number] = fragment.red
            to[4 * number + 1] = fragment.green
            to[4 * number + 2] = fragment.blue
            to[4 * number + 3] = fragment.alpha
        }
    }
}
