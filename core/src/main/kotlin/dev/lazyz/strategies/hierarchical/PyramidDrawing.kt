package dev.lazyz.strategies.hierarchical

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.AreaBounds
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.boundsIn
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachRow
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hierarchical.DepthPyramid.Companion.BLOCK

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
