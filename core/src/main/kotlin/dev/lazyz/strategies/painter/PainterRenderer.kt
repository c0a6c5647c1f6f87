package dev.lazyz.strategies.painter

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.requireInMemory
import java.io.IOException

/**
 * Paints from back to front: primitives painted later cover those painted before.
 *
 * Primitives are sorted so that each one comes after all those that it hides. An order of two primitives is used only
 * if it is proved for the whole pair: by their extents of depth, or because one lies entirely on one side of the
 * other's plane. Painting such pairs compares no depths. Pairs without a proved order (surfaces that cross, form a
 * cycle, or have no plane) are compared at the samples that they share, so the picture is exact.
 *
 * A frame with translucent primitives is painted in the same order: a translucent primitive becomes a layer over what
 * is there, an opaque one removes the layers that it is over. The layers of a sample are then blended from the nearest
 * on, as contract rule 5.5 defines. So such a frame is shaded at the end, and only where something shows through.
 *
 * Use it to visualize overdraw, to count it, or for teaching. It shades the fragments of opaque frames as it paints
 * them, and most of them are covered again. Where little overlaps (diagrams, maps), it shades no more than is visible.
 * Otherwise a renderer that shades late does less work.
 *
 * Memory: 8 bytes a sample, about 100 bytes a primitive, and 16 bytes for each corner of an outline that was examined;
 * 8 to 16 bytes for each translucent fragment that is before the opaque ones painted so far. Time: proportional to the
 * number of fragments; to find the order, O(n log n) for n primitives that overlap few others on the screen and in
 * depth, and O(corners) for each pair that does, up to about 500 n pairs. Thread safe; no state between calls.
 *
 * Source: Martin Newell, Richard Newell, Tom Sancha, "A Solution to the Hidden Surface Problem", Proceedings of the ACM
 * annual conference (1972). In the paper, a primitive that cannot be ordered is cut in two along a plane, which would
 * cause rounding; here it is left whole and compared by samples.
 */
public class PainterRenderer : Renderer {
    override val id: String get() = "painter"

    override val summary: String get() = "paints from back to front, compares samples where no order is proved"

    override val capabilities: Set<Capability> get() = setOf(Capability.TRANSPARENCY)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireInMemory(frame, this)
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val canvas = if (frame.hasTranslucency) LayeredPainting(frame, counters) else OpaquePainting(frame, counters)
        val pairs = PairOrder(frame, counters)
        val order = PaintOrder(frame, pairs)
        val brush = Brush(frame, canvas, pairs, counters)
        order.forEach { brush.paint(it) }
        canvas.finish(sink)
        counters.peakBytes = canvas.bytes + pairs.bytes + order.bytes + brush.bytes
        return counters.build()
    }

    override fun toString(): String = "PainterRenderer()"
}
