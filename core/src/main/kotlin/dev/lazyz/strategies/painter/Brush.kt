package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Spans

/**
 * Paints primitives onto a canvas, over what is proved to be behind, without looking at depths.
 *
 * The order of painting is meant to put every primitive over what it hides, but in a circle, or where surfaces cross,
 * no order can. So the brush asks who is there (not how deep): once for each primitive met, whether an order is
 * proved; and where none is, compares the two at the samples they share. What is on the canvas is at every sample the
 * visible one of all that was painted, whatever the order, because visibility is a minimum. The background is there
 * from the start.
 */
internal class Brush(
    private val frame: Frame,
    private val canvas: Canvas,
    private val pairs: PairOrder,
    private val counters: Counters,
) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val spans = Spans(region)

    /** For each primitive met, the background first: by whom it was last met, and what was proved then. */
    private val metBy = IntArray(frame.primitives.size + 1) { NOBODY }
    private val proved = ByteArray(frame.primitives.size + 1)

    /** Bytes held. */
    val bytes: Long get() = 5L * metBy.size

    fun paint(index: Int) {
        val primitive = frame.primitives[index]
        val rowStart = maxOf(primitive.rowStart, region.rowStart)
        val rowEnd = minOf(primitive.rowEnd, region.rowEnd)
        val cursor = primitive.cursor(rowStart)
        for (y in rowStart until rowEnd) {
            cursor.next(spans)
            for (i in 0 until spans.count) paintSpan(index, y, spans.start(i), spans.end(i))
        }
    }

    private fun paintSpan(index: Int, y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        var at = canvas.at(start, y)
        for (x in start until end) {
            val other = canvas.indices[at]
            val isVisible = when (orderOf(index, other)) {
                OVER -> true
                UNDER -> false
                else -> isVisible(x, y, index, other)
            }
            if (isVisible) canvas.paint(x, y, at, index)
            at++
        }
    }

    private fun isVisible(x: Int, y: Int, index: Int, other: Int): Boolean =
        test.key(canvas.depth(x, y, index), index) < test.key(canvas.depth(x, y, other), other)

    /** Returns what is proved of the primitive [index] and the [other], wherever both cover a sample. */
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
        const val NOBODY = -1
        const val OVER: Byte = 1
        const val UNDER: Byte = -1
        const val UNPROVED: Byte = 0
    }
}
