package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RowSink

/**
 * The picture painted so far: colour and primitive of each sample. Depth is evaluated at the end, for visible samples
 * only.
 */
internal class Canvas(private val frame: Frame, private val counters: Counters.Builder) {
    private val region = frame.region
    private val width = region.width
    private val fragment = Fragment()
    private val argb: IntArray

    /** The visible primitive of each sample, or [DepthTest.BACKGROUND], in rows from the top. */
    val indices: IntArray

    init {
        require(region.size <= MAX_SAMPLES) { "the painter holds at most $MAX_SAMPLES samples: ${region.size}" }
        argb = IntArray(region.size.toInt())
        indices = IntArray(region.size.toInt())
        argb.fill(frame.raster.background.toArgb())
        indices.fill(DepthTest.BACKGROUND)
    }

    /** Bytes held. */
    val bytes: Long get() = BYTES_PER_SAMPLE * region.size + Int.SIZE_BYTES * 3L * width

    /** Returns the array index of the sample at column [x] and row [y] of the raster. */
    fun at(x: Int, y: Int): Int = (y - region.rowStart) * width + (x - region.columnStart)

    /** Paints the primitive [index] at the sample at column [x] and row [y], whose array index is [at]. */
    fun paint(x: Int, y: Int, at: Int, index: Int) {
        counters.depthPasses++
        counters.shadingCalls++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        argb[at] = fragment.toArgb()
        indices[at] = index
    }

    /** Passes the rows to [sink]. */
    fun finish(sink: RowSink) {
        val colors = IntArray(width)
        val depths = IntArray(width)
        val visible = IntArray(width)
        for (y in region.rowStart until region.rowEnd) {
            val start = at(region.columnStart, y)
            argb.copyInto(colors, 0, start, start + width)
            indices.copyInto(visible, 0, start, start + width)
            for (i in 0 until width) depths[i] = depth(region.columnStart + i, y, visible[i])
            sink.row(y, colors, depths, visible)
        }
    }

    /** Evaluates the depth of the primitive [index], or of the background, at a sample that it covers. */
    fun depth(x: Int, y: Int, index: Int): Int {
        if (index == DepthTest.BACKGROUND) return frame.raster.backgroundDepth
        counters.depthEvaluations++
        return frame.primitives[index].depth(x, y)
    }

    private companion object {
        const val BYTES_PER_SAMPLE = 8L
        const val MAX_SAMPLES = Int.MAX_VALUE - 8L
    }
}
