package dev.lazyz.conformance.strangers4

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Spans

/** Draws primitives into a depth buffer, skips what a block's farthest key hides, and shades at the end. */
internal class PyramidDrawer(
    private val frame: Frame,
    private val image: PyramidImage,
    private val levels: PyramidLevels?,
    private val counters: Counters.Builder,
    private val spans: Spans,
    private val mistake: Mistake?,
) {
    private val region = frame.region
    private val test = frame.raster.depthTest

    /** Columns of the current row of blocks that have changed. */
    private var changedStart = Int.MAX_VALUE
    private var changedEnd = 0

    fun draw(primitive: Primitive, index: Int) {
        if (!primitive.touches(region)) return
        val area = Region(
            maxOf(primitive.columnStart, region.columnStart),
            maxOf(primitive.rowStart, region.rowStart),
            minOf(primitive.columnEnd, region.columnEnd),
            minOf(primitive.rowEnd, region.rowEnd),
        )
        val bound = test.boundOf(primitive, index)
        if (levels != null && isHidden(bound, levels.farthest(area))) return
        val cursor = primitive.cursor(area.rowStart)
        for (y in area.rowStart until area.rowEnd) {
            cursor.next(spans)
            for (i in 0 until spans.count) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
            if (levels != null && (y + 1 == area.rowEnd || (y + 1 - region.rowStart) % levels.side == 0)) {
                updateBlocks((y - region.rowStart) / levels.side, levels)
            }
        }
        levels?.update(area)
    }

    private fun isHidden(bound: Long, farthest: Long): Boolean =
        if (mistake == Mistake.PYRAMID_TIE_HIDDEN) bound ushr 32 >= farthest ushr 32 else bound >= farthest

    private fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        val form = primitive.depthForm
        var z = form?.at(start, y) ?: 0L
        val step = form?.dx ?: 0L
        val side = levels?.side ?: Int.MAX_VALUE
        var x = start
        while (x < end) {
            val column = (x - region.columnStart) / side
            val until = minOf(end.toLong(), region.columnStart + (column + 1L) * side).toInt()
            if (levels != null) {
                val bound = chunkBound(primitive, index, z, step, until - x)
                if (isHidden(bound, levels.block(column, (y - region.rowStart) / side))) {
                    if (mistake != Mistake.PYRAMID_STEP_SKIPPED) z += step * (until - x)
                    x = until
                    continue
                }
            }
            while (x < until) {
                val depth = if (form != null) (z shr 32).toInt() else primitive.depth(x, y)
                z += step
                counters.depthEvaluations++
                drawSample(x, y, depth, index)
                x++
            }
        }
    }

    /** Returns a key that nothing of the next [length] samples is before: a linear form is nearest at an end. */
    private fun chunkBound(primitive: Primitive, index: Int, z: Long, step: Long, length: Int): Long {
        if (primitive.depthForm == null) return test.boundOf(primitive, index)
        counters.depthEvaluations++
        val isNearestFirst = (step >= 0) != test.isGreatestFirst || mistake == Mistake.PYRAMID_BOUND_AT_START
        val nearest = if (isNearestFirst) z else z + step * (length - 1)
        return test.key((nearest shr 32).toInt(), index)
    }

    private fun drawSample(x: Int, y: Int, depth: Int, index: Int) {
        val at = (y - region.rowStart) * region.width + x - region.columnStart
        if (mistake == Mistake.PYRAMID_PASSES_ALL) counters.depthPasses++
        if (test.key(depth, index) >= test.key(image.depths[at], image.indices[at])) return
        if (mistake != Mistake.PYRAMID_PASSES_ALL) counters.depthPasses++
        image.depths[at] = depth
        image.indices[at] = index
        changedStart = minOf(changedStart, x)
        changedEnd = maxOf(changedEnd, x + 1)
    }

    private fun updateBlocks(blockRow: Int, levels: PyramidLevels) {
        if (changedStart < changedEnd) {
            val first = (changedStart - region.columnStart) / levels.side
            val last = (changedEnd - 1 - region.columnStart) / levels.side
            for (column in first..last) levels.setBlock(column, blockRow, farthestOf(column, blockRow, levels.side))
        }
        changedStart = Int.MAX_VALUE
        changedEnd = 0
    }

    private fun farthestOf(column: Int, blockRow: Int, side: Int): Long {
        var most = Long.MIN_VALUE
        for (row in blockRow * side until minOf(blockRow * side + side, region.height)) {
            for (i in column * side until minOf(column * side + side, region.width)) {
                val at = row * region.width + i
                most = maxOf(most, test.key(image.depths[at], image.indices[at]))
            }
        }
        return most
    }

    /** Shades what is visible, and hands out the rows in the image's own arrays, at their beginning. */
    fun finish(sink: RowSink) {
        val fragment = Fragment()
        val background = frame.raster.background.toArgb()
        counters.peakSuspensions = image.indices.count { it != DepthTest.BACKGROUND }.toLong()
        val out = if (mistake == Mistake.PYRAMID_ROW_ARRAYS) image.ofRow(region.width, counters) else image
        for (row in 0 until region.height) {
            for (i in 0 until region.width) {
                val at = row * region.width + i
                val index = image.indices[at]
                out.argb[i] = background
                if (index != DepthTest.BACKGROUND) {
                    counters.shadingCalls++
                    counters.shadingStarts++
                    fragment.moveTo(region.columnStart + i, region.rowStart + row)
                    frame.primitives[index].shade(fragment)
                    out.argb[i] = fragment.toArgb()
                }
                out.depths[i] = image.depths[at]
                out.indices[i] = index
            }
            sink.row(region.rowStart + row, out.argb, out.depths, out.indices)
        }
    }
}
