package dev.lazyz.raster

import dev.lazyz.Checkpoint
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.endIfInterrupted
import dev.lazyz.spi.Spans

/**
 * Whether the bounds of this primitive intersect [region]. If not, a renderer does not use the primitive (rule 7.7).
 */
internal fun Primitive.reaches(region: Region): Boolean =
    maxOf(rowStart, region.rowStart) < minOf(rowEnd, region.rowEnd) &&
        maxOf(columnStart, region.columnStart) < minOf(columnEnd, region.columnEnd)

/** Returns the part of the bounds of this primitive in [region]; null if they do not intersect. */
internal fun Primitive.boundsIn(region: Region): Region? =
    region.intersect(columnStart, rowStart, columnEnd, rowEnd)

/** As the other [boundsIn], for the primitive [index], without making an object of it. */
internal fun FrameContent.boundsIn(region: Region, index: Int): Region? {
    val number = batchNumber(index)
    if (number < 0) return single(index).boundsIn(region)
    return batches[number].boundsIn(region, index - batches[number].first)
}

/**
 * Calls [action] for each row of this primitive in [region], after its spans have been written to [spans]. Ends if the
 * calling thread is interrupted. For renderers that draw one primitive after the other.
 */
internal inline fun Primitive.forEachRow(region: Region, spans: Spans, action: (y: Int) -> Unit) {
    endIfInterrupted()
    if (!reaches(region)) return
    val first = maxOf(rowStart, region.rowStart)
    val cursor = cursor(first)
    for (y in first until minOf(rowEnd, region.rowEnd)) {
        endIfInterrupted()
        cursor.next(spans)
        action(y)
    }
}

/**
 * Calls [action] with the key of this primitive, whose submission index is [index], at each of its samples on row [y]
 * from column [start] until [end]: depth and index, and the visible fragment is the one with the least key. Where depth
 * is linear, each sample takes one addition.
 */
internal inline fun Primitive.forEachKey(
    index: Int,
    test: DepthTest,
    y: Int,
    start: Int,
    end: Int,
    action: (x: Int, key: Long) -> Unit,
) {
    val form = depthForm
    var z = form?.at(start, y) ?: 0L
    val step = form?.dx ?: 0L
    for (x in start until end) {
        val depth = if (form != null) (z shr 32).toInt() else depth(x, y)
        z += step
        action(x, test.key(depth, index))
    }
}

/** Calls [action] for all primitives in submission order, and passes [checkpoint] for each. */
internal inline fun Frame.forEachPrimitive(checkpoint: Checkpoint, action: (index: Int, primitive: Primitive) -> Unit) {
    content.makePrimitives(checkpoint)
    for ((index, primitive) in primitives.withIndex()) {
        checkpoint.pass()
        action(index, primitive)
    }
}

/**
 * Returns the primitives that reach the frame's region, in the order of their first rows in it: the row in the upper
 * half, the submission index in the lower half. Passes [checkpoint] for each primitive.
 */
internal fun Frame.byFirstRow(checkpoint: Checkpoint): LongArray {
    var count = 0
    forEachPrimitive(checkpoint) { _, primitive -> if (primitive.reaches(region)) count++ }
    val all = LongArray(count)
    var used = 0
    forEachPrimitive(checkpoint) { index, primitive ->
        val rowStart = maxOf(primitive.rowStart, region.rowStart)
        if (primitive.reaches(region)) all[used++] = rowStart.toLong() shl Int.SIZE_BITS or index.toLong()
    }
    return all.apply { sortKeys(checkpoint) }
}
