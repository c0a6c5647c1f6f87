package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.raster.VisibilityOrder

/**
 * The spans at the current column whose depth is no linear form: of spheres, and of primitives of the user's own.
 *
 * Nothing is known of their depths but bounds, so they are kept in order of the nearest. What lies behind all that is
 * visible so far ends the search, and is not evaluated; the others are compared sample by sample, as a depth buffer
 * would. Joining and leaving moves a part of the list, a few nanoseconds for a hundred spans.
 */
internal class CurvedSpans(private val frame: Frame, private val edges: ActiveEdges, private val counters: Counters) {
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val columnStart = frame.region.columnStart

    /** The nearest keys that the primitives can have, ascending, and the primitives' indices. */
    private var nearest = LongArray(INITIAL)
    private var indices = IntArray(INITIAL)
    private var count = 0

    /** Whether there are no such spans at the current column. */
    val isEmpty: Boolean get() = count == 0

    /** Bytes held at present. */
    val bytes: Long get() = 12L * nearest.size

    /** Lets [span] take part from the current column on. */
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

    /** Lets [span] take part no longer. */
    fun leave(span: Int) {
        val index = edges.primitive(span)
        val at = nearest.binarySearch(order.nearestKey(frame.primitives[index], index), 0, count)
        nearest.copyInto(nearest, at, at + 1, count)
        indices.copyInto(indices, at, at + 1, count)
        count--
    }

    /**
     * Compares the spans at the columns [start] until [end] of row [y] with what is visible there so far, in [depths]
     * and [visible] (from the region's first column), none of it behind the key [farthest].
     */
    fun show(depths: IntArray, visible: IntArray, start: Int, end: Int, y: Int, farthest: Long) {
        var farthestVisible = farthest
        for (candidate in 0 until count) {
            // What cannot be before the farthest visible sample is hidden, and so are all that follow
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
