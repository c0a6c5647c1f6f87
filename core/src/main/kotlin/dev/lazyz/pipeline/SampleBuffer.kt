package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.shading.LateShading

/**
 * The nearest fragment so far of each sample of a region: its visibility key and its colour. 12 bytes a sample. Used by
 * one thread.
 *
 * @throws IllegalArgumentException if [region] is not within [raster], or has too many samples
 */
internal class SampleBuffer(raster: Raster, val region: Region) {
    private val width = region.width
    private val test = raster.depthTest

    /** Colours, in rows from the top of the region. */
    val argb: IntArray

    /** Visibility keys, see [DepthTest.key], in the same order. */
    val keys: LongArray

    /** Bytes held. */
    val bytes: Long get() = argb.bytes + keys.bytes

    init {
        require(raster.region.contains(region)) { "$region must be within $raster" }
        require(region.size <= Image.MAX_SAMPLES) {
            "an image holds at most ${Image.MAX_SAMPLES} samples: ${region.size}"
        }
        argb = IntArray(region.size.toInt())
        keys = LongArray(region.size.toInt())
        argb.fill(raster.background.toArgb())
        keys.fill(test.key(raster.backgroundDepth, DepthTest.BACKGROUND))
    }

    /** Returns the index of the sample at column [x] of row [y]. */
    fun place(x: Int, y: Int): Int = (y - region.rowStart) * width + (x - region.columnStart)

    /** Passes every row to [sink], from top to bottom. Ends if the calling thread is interrupted. */
    fun handOut(sink: RowSink) {
        val colors = IntArray(width)
        val depths = IntArray(width)
        val indices = IntArray(width)
        for (row in 0 until region.height) {
            endIfInterrupted()
            argb.copyInto(colors, 0, row * width, (row + 1) * width)
            test.decode(keys, row * width, depths, indices)
            sink.row(region.rowStart + row, colors, depths, indices)
        }
    }

    companion object {
        const val BYTES_PER_SAMPLE: Long = 12
    }
}

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
            test.decode(keys, row * width, depths, indices)
            shading.shadeRow(band.rowStart + row, indices, colors)
            sink.row(band.rowStart + row, colors, depths, indices)
        }

        // All these shading calls were pending until now
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }
}

/** Stores the depths and the submission indices that [keys] encode from element [at] on, a row of them. */
internal fun DepthTest.decode(keys: LongArray, at: Int, depths: IntArray, indices: IntArray) {
    for (x in depths.indices) {
        depths[x] = depthOf(keys[at + x])
        indices[x] = indexOf(keys[at + x])
    }
}
