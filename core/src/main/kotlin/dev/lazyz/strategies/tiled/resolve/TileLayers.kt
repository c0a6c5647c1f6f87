package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Blending
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.bytes
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.sortKeys
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * The translucent fragments of one tile that are before the opaque ones, by sample and from near to far. Belongs to one
 * thread; reused for each tile.
 *
 * Fragments are recorded as they are found, and then sorted: a counting sort by sample, then a sort of each sample's
 * few fragments by key. No memory is held if no tile has translucent primitives.
 *
 * @param opaque the keys of the opaque primitives, final before the first fragment is added
 */
internal class TileLayers(
    private val opaque: VisibilityBuffer,
    private val test: DepthTest,
    private val counters: Counters.Builder
) {
    /** Key and sample of each fragment, in order of arrival. */
    private var keys = LongArray(0)
    private var samples = IntArray(0)
    private var count = 0

    /** The keys by sample: those of sample s end at `ends[s]`, where those of s + 1 begin. */
    private var ordered = LongArray(0)
    private var ends = IntArray(0)

    private val blending = Blending()

    /** Whether there is nothing to blend. */
    val isEmpty: Boolean get() = count == 0

    /** Peak number of bytes held. */
    val bytes: Long get() = keys.bytes + ordered.bytes + samples.bytes + ends.bytes

    /** Begins a tile. */
    fun begin() {
        count = 0
    }

    /**
     * Records the part of a translucent primitive's span on row [y] that is within the tile and before the opaque keys.
     */
    fun add(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        val from = maxOf(start, opaque.columnStart)
        val until = minOf(end, opaque.columnEnd)
        if (from >= until) return
        reserve(count + until - from)
        counters.depthEvaluations += until - from
        val before = count
        primitive.forEachKey(index, test, y, from, until) { x, key ->
            if (key < opaque.at(x, y)) {
                keys[count] = key
                samples[count++] = opaque.place(x, y)
            }
        }
        counters.depthPasses += count - before
    }

    private fun reserve(size: Int) {
        if (size <= keys.size) return
        keys = keys.copyOf(size + size / 2)
        samples = samples.copyOf(size + size / 2)
    }

    /** Sorts the fragments, after all have been recorded. Passes [checkpoint] for each sample that has some. */
    fun order(checkpoint: Checkpoint) {
        if (isEmpty) return
        if (ends.isEmpty()) ends = IntArray(opaque.size + 1)
        if (ordered.size < count) ordered = LongArray(keys.size)
        ends.fill(0)
        for (i in 0 until count) ends[samples[i] + 1]++
        for (sample in 0 until opaque.size) ends[sample + 1] += ends[sample]
        for (i in 0 until count) ordered[ends[samples[i]]++] = keys[i]
        for (sample in 0 until opaque.size) {
            if (end(sample) > start(sample)) ordered.sortKeys(checkpoint, start(sample), end(sample))
        }
    }

    private fun start(sample: Int): Int = if (sample == 0) 0 else ends[sample - 1]

    private fun end(sample: Int): Int = ends[sample]

    /** Returns the nearest key at a [sample], or [none] if there is no translucent fragment. */
    fun nearest(sample: Int, none: Long): Long = if (start(sample) < end(sample)) ordered[start(sample)] else none

    /**
     * Blends the fragments at a [sample] with what is behind them (contract rule 5.5), and returns the packed colour.
     * [shade] returns the colour of the fragment with a key; [backdrop] is the key of the opaque primitive, or null for
     * [background].
     */
    inline fun blend(sample: Int, backdrop: Long?, background: Rgba, shade: (key: Long) -> Fragment): Int {
        val first = start(sample)
        val layers = end(sample) - first
        return blending.blend(layers, backdrop != null, background) { i ->
            shade(if (i < layers) ordered[first + i] else checkNotNull(backdrop))
        }
    }
}
