package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.shading.LateShading

/**
 * Converts visibility keys to rows: decodes depth and primitive of each key, shades the visible samples, and passes the
 * row to the sink.
 *
 * Used by renderers that hold a key for each sample of several rows. Used by one thread.
 */
internal class KeyedRows(
    private val frame: Frame,
    private val shading: LateShading,
    private val counters: Counters.Builder
) {
    private val width = frame.width
    private val test = frame.raster.depthTest
    private val colors = IntArray(width)
    private val depths = IntArray(width)
    private val indices = IntArray(width)

    /** Peak memory so far, in bytes. */
    val bytes: Long get() = colors.bytes + depths.bytes + indices.bytes + shading.peakBytes

    /**
     * Passes the rows of [band], which is as wide as the frame's region, to [sink]. [keys] has one key a sample, in
     * rows from the top of the band. Ends if the calling thread is interrupted.
     */
    fun handOut(band: Region, keys: LongArray, sink: RowSink) {
        val shadedBefore = counters.shadingCalls
        for (row in 0 until band.height) {
            endIfInterrupted()
            for (i in 0 until width) {
                val key = keys[row * width + i]
                depths[i] = test.depthOf(key)
                indices[i] = test.indexOf(key)
            }
            shading.shadeRow(band.rowStart + row, indices, colors)
            sink.row(band.rowStart + row, colors, depths, indices)
        }

        // All these shading calls were pending until now
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }
}
