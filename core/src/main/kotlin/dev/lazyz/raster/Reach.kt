package dev.lazyz.raster

import dev.lazyz.Primitive
import dev.lazyz.Region

/** Whether this primitive's bounds say that it may cover something of [region]; or it is left alone (rule 7.7). */
internal fun Primitive.reaches(region: Region): Boolean =
    maxOf(rowStart, region.rowStart) < minOf(rowEnd, region.rowEnd) &&
        maxOf(columnStart, region.columnStart) < minOf(columnEnd, region.columnEnd)
