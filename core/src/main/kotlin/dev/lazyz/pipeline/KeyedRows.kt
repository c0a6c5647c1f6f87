package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.shading.LateShading

/**
 * Turns visibility keys into rows: takes depth and primitive out of each key, shades what is visible, hands the row
 * out.
 *
 * Shared by the renderers that hold a key for each sample of several rows. Belongs to one thread.
 */
internal class KeyedRows(private val frame: Frame, private val shading: LateShading, private val counters: Counters) {
    private val width = frame.width
    private val test = frame.raster.depthTest
    private val colors = IntArray(width)
    private val depths = IntArray(width)
    private val indices = IntArray(width)

    /** Bytes held, at their peak so far. */
    val bytes: Long get() = 3L * Int.SIZE_BYTES * width + shading.peakBytes

    /** Hands the rows of [band], as wide as the frame's region, to [sink]. [keys] are in rows from the band's top. */
    fun handOut(band: Region, keys: LongArray, sink: RowSink) {
        val shadedBefore = counters.shadingCalls
        for (row in 0 until band.height) {
            for (i in 0 until width) {
                val key = keys[row * width + i]
                depths[i] = test.depthOf(key)
                indices[i] = test.indexOf(key)
            }
            shading.shadeRow(band.rowStart + row, indices, colors)
            sink.row(band.rowStart + row, colors, depths, indices)
        }

        // Until now all these were suspended
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }
}
