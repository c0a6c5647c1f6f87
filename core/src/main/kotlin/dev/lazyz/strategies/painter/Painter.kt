package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.requireOpaque

/**
 * Paints from back to front: what is painted later covers what was painted before.
 *
 * Primitives are put in an order in which each one comes after all that it hides. An order is taken only if it is
 * proved for the whole pair: by extents of depth, or because one lies wholly on one side of the other's plane.
 * Painting then compares no depths. Pairs that nothing is proved for (surfaces that cross, or lie in a circle, or
 * have no plane) are compared at the samples they share, so the picture is exact.
 *
 * Use it to see overdraw, to count it, or to teach; it shades every fragment, most of them to be covered again. Where
 * little overlaps (diagrams, maps) that is no more than is seen. Otherwise a renderer that shades late does less.
 *
 * Memory: 8 bytes a sample, about 100 bytes a primitive, and 16 bytes a corner of the outlines that were looked at.
 * Time: proportional to the fragments; to find the order, O(n log n) for n primitives that overlap few others on the
 * screen and in depth, and O(corners) for each pair that does, up to some 500 n pairs. Thread safe; no state between
 * calls.
 *
 * Source: Martin Newell, Richard Newell, Tom Sancha, "A Solution to the Hidden Surface Problem", Proceedings of the
 * ACM annual conference (1972). There what cannot be ordered is cut in two along a plane, which would round; here it
 * is left whole and compared by samples.
 */
public class Painter : Renderer {
    override val id: String get() = "painter"

    override val summary: String get() = "paints from back to front, compares samples where no order is proved"

    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val counters = Counters()
        counters.primitives = frame.primitives.size.toLong()
        val canvas = Canvas(frame, counters)
        val pairs = PairOrder(frame, counters)
        val order = PaintOrder(frame, pairs)
        val brush = Brush(frame, canvas, pairs, counters)
        order.forEach { brush.paint(it) }
        counters.peakBytes = canvas.bytes + pairs.bytes + order.bytes + brush.bytes
        canvas.finish(sink)
        return counters
    }

    override fun toString(): String = "Painter()"
}
