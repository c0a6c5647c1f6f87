package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder

/**
 * The spans at the current column whose depth is not a linear form: those of spheres and of custom primitives.
 *
 * Only bounds of their depths are known, so the spans are sorted by the bound of their nearest key. The search ends at
 * the first span that is behind everything visible so far, without evaluating it. The spans before it are compared
 * sample by sample, as in a depth buffer. Adding or removing a span moves a part of the list, which takes a few
 * nanoseconds for a hundred spans.
 */
internal class CurvedSpans(
    private val frame: Frame,
    private val edges: ActiveEdges,
    private val counters: Counters.Builder
) {
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val columnStart = frame.region.columnStart

    /** Lower bounds of the primitives' keys, ascending, and the primitives' indices. */
    private var nearest = LongArray(INITIAL)
    private var indices = IntArray(INITIAL)
    private var count = 0

    /** Whether there are no such spans at the current column. */
    val isEmpty: Boolean get() = count == 0

    /** Bytes currently held. */
    val bytes: Long get() = nearest.bytes + indices.bytes

    /** Adds [span] at the current column. */
    fun join(span: Int) {
        if (count == nearest.size) {
            nearest = nearest.copyOf(2 * count)
            indices = indices.copyOf(2 * count)
        }
        val index = edges.primitive(span)
        val key = order.nearestKey(frame.primitives[index], index)
        val at = -nearest.binarySearch(key, 0, count) - 1
        nearest.copyInto(nearest, at + 1, at, count)
        indices.copyInto(indices, at + 1, at, count)
        nearest[at] = key
        indices[at] = index
        count++
    }

    /** Removes [span] at the current column. */
    fun leave(span: Int) {
        val index = edges.primitive(span)
        val at = nearest.binarySearch(order.nearestKey(frame.primitives[index], index), 0, count)
        nearest.copyInto(nearest, at, at + 1, count)
        indices.copyInto(indices, at, at + 1, count)
        count--
    }

    /**
     * Compares the spans at the columns [start] until [end] of row [y] with what is visible there so far, in [depths]
     * and [visible] (which start at the region's first column). None of the visible keys is behind [farthest].
     */
    fun show(depths: IntArray, visible: IntArray, start: Int, end: Int, y: Int, farthest: Long) {
        var farthestVisible = farthest
        for (candidate in 0 until count) {
            endIfInterrupted()

            // A span that is behind the farthest visible sample is hidden, and so are all spans after it
            if (nearest[candidate] > farthestVisible) return
            val index = indices[candidate]
            val primitive = frame.primitives[index]
            counters.depthEvaluations += end - start
            farthestVisible = Long.MIN_VALUE
            for (x in start until end) {
                val i = x - columnStart
                val depth = primitive.depth(x, y)
                val key = test.key(depth, index)
                val visibleKey = test.key(depths[i], visible[i])
                if (key < visibleKey) {
                    depths[i] = depth
                    visible[i] = index
                    counters.depthPasses++
                }
                farthestVisible = maxOf(farthestVisible, minOf(key, visibleKey))
            }
        }
    }

    private companion object {
        const val INITIAL = 16
    }
}
