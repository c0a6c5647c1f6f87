package dev.lazyz.strategies.bsp

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.forEachRow
import dev.lazyz.raster.sortKeys
import dev.lazyz.shading.LateShading
import dev.lazyz.shading.LayerShading

/**
 * The nearest opaque primitive drawn so far at each sample, and the translucent ones before it. A primitive's number is
 * its place in the order of drawing. Depths are evaluated where an order is not proved, and in the end.
 */
internal class OwnedSamples(private val frame: Frame, coherence: Coherence, private val counters: Counters.Builder) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val late = LateShading(frame, coherence, counters, Checkpoint.CALLER)
    private val spans = region.spans()

    /** The number of the primitive that owns each sample, or [NONE], in rows from the top. */
    private val owners: IntArray

    /** Submission indices by number. */
    private val indices = IntArray(frame.primitives.size)

    /** Number of opaque primitives drawn so far. */
    var drawn: Int = 0
        private set

    /** Translucent fragments: the latest of each sample, their keys, and the one before; empty if there are none. */
    private val latest: IntArray
    private var layerKeys = LongArray(INITIAL)
    private var before = IntArray(INITIAL)
    private var layers = 0

    /** Bytes held. */
    val bytes: Long
        get() = owners.bytes + indices.bytes + latest.bytes + layerKeys.bytes + before.bytes + late.peakBytes +
            Int.SIZE_BYTES * 3L * region.width

    init {
        require(region.size <= Image.MAX_SAMPLES) { "bsp holds at most ${Image.MAX_SAMPLES} samples: ${region.size}" }
        owners = IntArray(region.size.toInt())
        owners.fill(NONE)
        latest = IntArray(if (frame.hasTranslucency) owners.size else 0)
        latest.fill(NONE)
    }

    /** Draws the opaque primitive [index], which is behind all that were drawn before but the [undecided] ones. */
    fun draw(index: Int, undecided: DrawnRanges) {
        val number = drawn++
        indices[number] = index
        forEachVisible(index, undecided) { at, _, _ ->
            if (owners[at] == NONE) counters.peakSuspensions++
            owners[at] = number
        }
    }

    /** Draws the translucent primitive [index], after all opaque ones. It may be before the [undecided] ones. */
    fun drawLayer(index: Int, undecided: DrawnRanges) {
        val primitive = frame.primitives[index]
        forEachVisible(index, undecided) { at, x, y ->
            if (layers == before.size) {
                before = before.copyOf(2 * layers)
                layerKeys = layerKeys.copyOf(2 * layers)
            }
            layerKeys[layers] = key(primitive, index, x, y)
            before[layers] = latest[at]
            latest[at] = layers++
            counters.peakSuspensions++
        }
    }

    /** Calls [action] with each sample at which the primitive [index] is before the owner, or before the background. */
    private inline fun forEachVisible(index: Int, undecided: DrawnRanges, action: (at: Int, x: Int, y: Int) -> Unit) {
        val primitive = frame.primitives[index]
        val isHidden = order.nearestKey(primitive, index) >= backgroundKey
        val isBefore = order.farthestKey(primitive, index) < backgroundKey
        primitive.forEachRow(region, spans) { y ->
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                if (isHidden) continue
                var at = (y - region.rowStart) * region.width + spans.start(i) - region.columnStart
                for (x in spans.start(i) until spans.end(i)) {
                    val owner = owners[at]
                    val isVisible = when {
                        owner == NONE -> isBefore || key(primitive, index, x, y) < backgroundKey
                        owner in undecided -> isBefore(primitive, index, owner, x, y)
                        else -> false
                    }
                    if (isVisible) {
                        counters.depthPasses++
                        action(at, x, y)
                    }
                    at++
                }
            }
        }
    }

    private fun isBefore(primitive: Primitive, index: Int, owner: Int, x: Int, y: Int): Boolean {
        val other = indices[owner]
        return key(primitive, index, x, y) < key(frame.primitives[other], other, x, y)
    }

    private fun key(primitive: Primitive, index: Int, x: Int, y: Int): Long {
        counters.depthEvaluations++
        return test.key(primitive.depth(x, y), index)
    }

    /** Shades what is visible, and passes the rows to [sink]. */
    fun finish(sink: RowSink) {
        val shading = LayerShading(frame, late)
        val argb = IntArray(region.width)
        val depths = IntArray(region.width)
        val visible = IntArray(region.width)
        val stack = LayerStack()
        for (y in region.rowStart until region.rowEnd) {
            endIfInterrupted()
            late.beginRow()
            for (i in 0 until region.width) {
                val at = (y - region.rowStart) * region.width + i
                val x = region.columnStart + i
                val backdrop = if (owners[at] == NONE) DepthTest.BACKGROUND else indices[owners[at]]
                if (latest.isNotEmpty()) stack.collect(latest[at])
                val key = when {
                    stack.count > 0 -> stack.keys[0]
                    backdrop == DepthTest.BACKGROUND -> backgroundKey
                    else -> key(frame.primitives[backdrop], backdrop, x, y)
                }
                argb[i] = shading.shade(x, y, stack.indices, stack.count, backdrop)
                depths[i] = test.depthOf(key)
                visible[i] = test.indexOf(key)
            }
            sink.row(y, argb, depths, visible)
        }
    }

    /** The translucent fragments of one sample, from near to far. */
    private inner class LayerStack {
        var keys = LongArray(INITIAL)
        var indices = IntArray(INITIAL)
        var count = 0

        /** Takes the fragments from [latest] on. */
        fun collect(latest: Int) {
            count = 0
            var layer = latest
            while (layer != NONE) {
                if (count == keys.size) {
                    keys = keys.copyOf(2 * count)
                    indices = IntArray(2 * count)
                }
                keys[count++] = layerKeys[layer]
                layer = before[layer]
            }
            keys.sortKeys(Checkpoint.CALLER, 0, count)
            for (i in 0 until count) indices[i] = test.indexOf(keys[i])
        }
    }

    private companion object {
        const val NONE = -1
        const val INITIAL = 16
    }
}
