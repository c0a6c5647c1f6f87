package dev.lazyz.raster

import dev.lazyz.Primitive
import dev.lazyz.Region

/**
 * Whether the bounds of this primitive intersect [region]. If not, a renderer does not use the primitive (rule 7.7).
 */
internal fun Primitive.reaches(region: Region): Boolean =
    maxOf(rowStart, region.rowStart) < minOf(rowEnd, region.rowEnd) &&
        maxOf(columnStart, region.columnStart) < minOf(columnEnd, region.columnEnd)
