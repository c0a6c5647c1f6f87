package dev.lazyz.strategies.hierarchical

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.LibraryThreads
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.Workers
import dev.lazyz.bytes
import dev.lazyz.pipeline.GroupedPrimitives
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.pipeline.KeyedRows
import dev.lazyz.pipeline.StreamedRendering
import dev.lazyz.pipeline.bandBytes
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.sortKeys
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading
import java.io.IOException

/**
 * A depth buffer that maintains the farthest depth of each block of samples, and of each block of blocks.
 *
 * Primitives are drawn from near to far, or in the order of submission, see [Order]. A primitive that is behind the
 * farthest sample of all the blocks that it may reach is hidden, which takes a few comparisons. Otherwise each block is
 * tested before its samples are. Visible samples are shaded after all primitives are drawn.
 *
 * Use it where much is hidden and the picture fits into memory. Where little is hidden, it is a depth buffer with an
 * additional sort. For pictures larger than memory use a renderer that streams rows.
 *
 * A streamed frame (see [Frame.isStreamed]) is rendered part by part, each under a pyramid of its own, into a picture
 * in memory of 12 bytes a sample. What is behind the parts before is not rejected.
 *
 * Memory: 8 bytes a sample, 12 a block of 64 samples, and 8 a primitive to sort it. Time: the fragments in blocks where
 * they are not hidden, plus one step for each row of a hidden primitive, plus n log n to sort n primitives. Thread
 * safe; no state between calls.
 *
 * A streamed frame (see [Frame.isStreamed]) is rendered part by part into a picture in memory, at 12 bytes a sample, in
 * bands of rows if that is more than [RenderOptions.bandBytes], by default a third of the heap. Each part is shaded
 * where it is nearest within itself.
 *
 * Source: Ned Greene, Michael Kass, Gavin Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993. In the paper, an
 * octree yields the primitives from near to far and rejects many at once; here they are sorted, and rejected one by
 * one.
 *
 * @param options only [RenderOptions.coherence] and [RenderOptions.bandBytes] are used
 * @param order the order in which primitives are drawn; changes the cost and never the image
 */
public class HierarchicalRenderer @JvmOverloads constructor(
    private val options: RenderOptions = RenderOptions(),
    private val order: Order = Order.NEAREST_FIRST,
) : StreamingRenderer {
    init {
        options.requireSupportedBy(this)
    }

    /** The order in which a [HierarchicalRenderer] draws the primitives of a frame. */
    public enum class Order {
        /** From near to far, by the nearest depth that a primitive can have. Most of what is hidden is rejected. */
        NEAREST_FIRST,

        /**
         * In the order of submission, without sorting. Use it for frames that are already sorted, or to show how the
         * pyramid depends on the order: submitted from far to near, nothing is rejected.
         */
        SUBMISSION,
    }

    override val id: String get() = "hierarchical"

    override val summary: String get() = "depth buffer under a pyramid that rejects primitives, then blocks of samples"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.COHERENCE)

    override fun configured(options: RenderOptions): Renderer = HierarchicalRenderer(options, order)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val parts = frame.content.parts ?: return renderWhole(frame, sink)
        val workers = Workers(1, LibraryThreads)
        return StreamedRendering(frame, parts, workers, bandBytes(options.bandBytes), ::renderWhole).run(sink)
    }

    /**
     * Begins an image. Visible primitives are kept until it ends; hidden ones are dropped whenever there are as many
     * again.
     */
    override fun begin(raster: Raster, region: Region): Rendering {
        val primitives = GroupedPrimitives(raster, region, ::renderWhole)
        return GuardedDrawing(this, primitives::draw, primitives::finish)
    }

    private fun renderWhole(frame: Frame, sink: RowSink): Counters {
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val test = frame.raster.depthTest

        // Draw in the chosen order
        val drawing = PyramidDrawing(frame, counters)
        val sorted = if (order == Order.NEAREST_FIRST) nearestFirst(frame) else null
        if (sorted != null) {
            for (key in sorted) drawing.draw(test.indexOf(key))
        } else {
            frame.forEachPrimitive(Checkpoint.CALLER) { index, _ -> drawing.draw(index) }
        }

        // Shade after all primitives are drawn
        val rows = KeyedRows(frame, LateShading(frame, options.coherence, counters, Checkpoint.CALLER), counters)
        rows.handOut(frame.region, drawing.keys, sink)
        counters.peakBytes = drawing.bytes + (sorted?.bytes ?: 0) + rows.bytes
        return counters.build()
    }

    override fun toString(): String = "HierarchicalRenderer($options, $order)"

    /** Returns a lower bound of the keys of each primitive's fragments, ascending. */
    private fun nearestFirst(frame: Frame): LongArray {
        val order = VisibilityOrder(frame.raster.depthTest)
        val keys = LongArray(frame.primitives.size)
        frame.forEachPrimitive(Checkpoint.CALLER) { index, primitive ->
            keys[index] = order.nearestKey(primitive, index)
        }
        keys.sortKeys(Checkpoint.CALLER)
        return keys
    }
}
