package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.raster.forEachRow
import dev.lazyz.spi.Spans

/**
 * Paints primitives onto a canvas, over primitives that are proved to be behind, without comparing depths.
 *
 * The order of painting is chosen so that every primitive is painted after those that it hides. If primitives form a
 * cycle or surfaces cross, no such order exists. The brush therefore looks at the primitives already painted at each
 * sample (not at their depths). Once for each pair of primitives, it checks whether an order is proved; if not, it
 * compares the two at the samples that they share. At every sample, the canvas thus holds the visible one of all
 * primitives painted so far, in any order of painting, because visibility is a minimum. The background is painted
 * first.
 */
internal class Brush(
    private val frame: Frame,
    private val canvas: Painting,
    private val pairs: PairOrder,
    private val counters: Counters.Builder,
) {
    private val test = frame.raster.depthTest
    private val spans = frame.region.spans()

    /**
     * For each painted primitive (element 0 is the background), the last primitive painted over it, and the order
     * proved for the two.
     */
    private val metBy = IntArray(frame.primitives.size + 1) { NONE }
    private val proved = ByteArray(frame.primitives.size + 1)

    /** Bytes held. */
    val bytes: Long get() = 5L * metBy.size

    fun paint(index: Int) {
        frame.primitives[index].forEachRow(frame.region, spans) { y ->
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                canvas.paint(index, y, spans.start(i), spans.end(i), this)
            }
        }
    }

    /** Whether the primitive [index] is visible before [other] at a sample that both cover. */
    fun isOver(x: Int, y: Int, index: Int, other: Int): Boolean = when (orderOf(index, other)) {
        OVER -> true
        UNDER -> false
        else -> test.key(canvas.depth(x, y, index), index) < test.key(canvas.depth(x, y, other), other)
    }

    /** Returns the order that is proved for the primitive [index] and the [other] wherever both cover a sample. */
    private fun orderOf(index: Int, other: Int): Byte {
        val at = other + 1
        if (metBy[at] != index) {
            metBy[at] = index
            proved[at] = when {
                pairs.isBefore(index, other) -> OVER
                pairs.isBefore(other, index) -> UNDER
                else -> UNPROVED
            }
        }
        return proved[at]
    }

    private companion object {
        const val NONE = -1
        const val OVER: Byte = 1
        const val UNDER: Byte = -1
        const val UNPROVED: Byte = 0
    }
}
