package dev.lazyz.strategies.hierarchical

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LibraryThreads
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.Workers
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.pipeline.GroupedPrimitives
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.pipeline.KeyedRows
import dev.lazyz.pipeline.StreamedRendering
import dev.lazyz.pipeline.bandBytes
import dev.lazyz.raster.AreaBounds
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.boundsIn
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.forEachRow
import dev.lazyz.raster.sortKeys
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hierarchical.DepthPyramid.Companion.BLOCK
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

/**
 * Draws primitives on a [DepthPyramid], one at a time. It first tests whether the whole primitive is hidden, then each
 * block, and only then each sample. No depths are evaluated for hidden primitives and blocks.
 */
internal class PyramidDrawing(private val frame: Frame, private val counters: Counters.Builder) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val bounds = AreaBounds(test, counters)

    /** The keys of all primitives drawn so far. */
    val pyramid: DepthPyramid = DepthPyramid(region, test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND))

    private val spans = region.spans()

    /** The test result of each block in the current row of blocks: [UNKNOWN], [HIDDEN] or [OPEN]. */
    private val answers = ByteArray((region.width + BLOCK - 1) / BLOCK)

    /** The current primitive, its index, and bounds of the keys of all its fragments. */
    private lateinit var primitive: Primitive
    private var index = 0
    private var nearestKey = 0L
    private var farthestKey = 0L

    /** The part of the region that the current primitive may cover. */
    private lateinit var box: Region

    /** The visible key of each sample, in rows from the region's top. */
    val keys: LongArray get() = pyramid.keys

    /** Bytes held. */
    val bytes: Long get() = pyramid.bytes + answers.size + spans.bytes

    /** Draws the primitive [index]. */
    fun draw(index: Int) {
        this.index = index
        primitive = frame.primitives[index]
        nearestKey = order.nearestKey(primitive, index)
        farthestKey = order.farthestKey(primitive, index)
        box = primitive.boundsIn(region) ?: return endIfInterrupted()
        val isHidden = isHidden()

        // If the primitive is hidden, only count its samples
        primitive.forEachRow(box, spans) { y ->
            if (isHidden) {
                for (i in 0 until spans.count) counters.fragments += spans.end(i) - spans.start(i)
                return@forEachRow
            }
            if (y == box.rowStart || (y - region.rowStart) % BLOCK == 0) forgetBlocks()
            for (i in 0 until spans.count) drawSpan(y, spans.start(i), spans.end(i))
        }
    }

    private fun blockColumn(x: Int): Int = (x - region.columnStart) / BLOCK

    private fun blockRow(y: Int): Int = (y - region.rowStart) / BLOCK

    /** Whether the primitive is hidden everywhere. */
    private fun isHidden(): Boolean = pyramid.isHidden(
        nearestKey,
        blockColumn(box.columnStart),
        blockRow(box.rowStart),
        blockColumn(box.columnEnd - 1),
        blockRow(box.rowEnd - 1),
    )

    private fun forgetBlocks() {
        answers.fill(UNKNOWN, blockColumn(box.columnStart), blockColumn(box.columnEnd - 1) + 1)
    }

    /** Draws a span, divided into one run for each block that it crosses. */
    private fun drawSpan(y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        var x = start
        while (x < end) {
            val block = blockColumn(x)
            val runEnd = minOf(end, region.columnStart + (block + 1) * BLOCK)
            if (answers[block] == UNKNOWN) answers[block] = if (isHidden(block, blockRow(y))) HIDDEN else OPEN
            if (answers[block] == OPEN) drawRun(y, x, runEnd, block)
            x = runEnd
        }
    }

    /** Whether the primitive is hidden in a block. */
    private fun isHidden(column: Int, row: Int): Boolean {
        // The bounds of the whole primitive decide most blocks, in one direction or the other
        if (pyramid.isHidden(nearestKey, 0, column, row)) return true
        if (primitive.depthForm == null || pyramid.upperBound(column, row) > farthestKey) return false

        // Otherwise use the bound of its depth plane: one depth evaluation for up to 64 samples
        val x = region.columnStart + column * BLOCK
        val y = region.rowStart + row * BLOCK
        val area = checkNotNull(box.intersect(x, y, x + BLOCK, y + BLOCK))
        return pyramid.isHidden(bounds.nearestKey(primitive, index, area), 0, column, row)
    }

    /** Draws the columns [start] until [end] of row [y], in the block at [column]. Samples keep the lesser key. */
    private fun drawRun(y: Int, start: Int, end: Int, column: Int) {
        counters.depthEvaluations += end - start
        val row = blockRow(y)
        val farthest = if (pyramid.isCurrent(column, row)) pyramid.upperBound(column, row) else NO_KEY
        val keys = pyramid.keys
        var at = (y - region.rowStart) * region.width + (start - region.columnStart)
        var passes = 0
        var replaced = 0
        primitive.forEachKey(index, test, y, start, end) { _, key ->
            val old = keys[at]
            if (key < old) {
                keys[at] = key
                passes++
                if (old == farthest) replaced++
            }
            at++
        }
        counters.depthPasses += passes
        if (replaced > 0) pyramid.replaced(column, row, replaced)
    }

    private companion object {
        const val UNKNOWN: Byte = 0
        const val HIDDEN: Byte = 1
        const val OPEN: Byte = 2
        const val NO_KEY = -1L
    }
}
