package dev.lazyz.raster

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region

/**
 * Whether the bounds of this primitive intersect [region]. If not, a renderer does not use the primitive (rule 7.7).
 */
internal fun Primitive.reaches(region: Region): Boolean =
    maxOf(rowStart, region.rowStart) < minOf(rowEnd, region.rowEnd) &&
        maxOf(columnStart, region.columnStart) < minOf(columnEnd, region.columnEnd)

/**
 * Returns the primitives that reach the frame's region, in the order of their first rows in it: the row in the upper
 * half, the submission index in the lower half.
 */
internal fun Frame.byFirstRow(): LongArray {
    val all = LongArray(primitives.size)
    var used = 0
    for ((index, primitive) in primitives.withIndex()) {
        val rowStart = maxOf(primitive.rowStart, region.rowStart)
        if (primitive.reaches(region)) all[used++] = rowStart.toLong() shl 32 or index.toLong()
    }
    return all.copyOf(used).apply { sort() }
}
