package dev.lazyz.pipeline

import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted

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
            for (x in 0 until width) {
                val key = keys[row * width + x]
                depths[x] = test.depthOf(key)
                indices[x] = test.indexOf(key)
            }
            sink.row(region.rowStart + row, colors, depths, indices)
        }
    }

    companion object {
        const val BYTES_PER_SAMPLE: Long = 12
    }
}
