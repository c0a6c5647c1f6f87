package dev.lazyz.strategies.hierarchical

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.KeyedRows
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading

/**
 * A depth buffer that knows how far away the farthest sample of each block is, and of each block of blocks.
 *
 * Primitives are taken nearest first. One that is behind the farthest sample of all the blocks it may reach is
 * hidden, by a handful of comparisons; of one that is not, each block is asked before its samples are. What is
 * visible is shaded once all are drawn.
 *
 * Use it where much is hidden and the picture fits memory. Where little is hidden it is a depth buffer that sorts. For
 * pictures that are larger than memory use a renderer that streams rows.
 *
 * Memory: 8 bytes a sample, 12 a block of 64, and 8 a primitive. Time: the fragments in blocks where they are not
 * hidden, a step for each row of what is hidden; n log n for n primitives. Thread safe; no state between calls.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993. There an octree
 * brings the primitives nearest first and rejects many at once; here they are sorted, and rejected one by one.
 *
 * @param options [RenderOptions.coherence] is heeded
 */
public class HierarchicalZBuffer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    Renderer {
    override val id: String get() = "hierarchical"

    override val summary: String get() = "depth buffer under a pyramid that rejects primitives, then blocks of samples"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.COHERENCE)

    override fun configured(options: RenderOptions): Renderer = HierarchicalZBuffer(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val counters = Counters()
        counters.primitives = frame.primitives.size.toLong()
        val test = frame.raster.depthTest

        // Draw, nearest first
        val nearestFirst = nearestFirst(frame)
        val drawing = PyramidDrawing(frame, counters)
        for (key in nearestFirst) drawing.draw(test.indexOf(key))

        // Only now make the colours
        val rows = KeyedRows(frame, LateShading(frame, options.coherence, counters), counters)
        rows.handOut(frame.region, drawing.keys, sink)
        counters.peakBytes = drawing.bytes + Long.SIZE_BYTES * nearestFirst.size + rows.bytes
        return counters
    }

    override fun toString(): String = "HierarchicalZBuffer($options)"

    /** Returns for each primitive the key that none of its fragments is before, ascending. */
    private fun nearestFirst(frame: Frame): LongArray {
        val order = VisibilityOrder(frame.raster.depthTest)
        val keys = LongArray(frame.primitives.size)
        for ((index, primitive) in frame.primitives.withIndex()) keys[index] = order.nearestKey(primitive, index)
        keys.sort()
        return keys
    }
}
