package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RowSink
import dev.lazyz.endIfInterrupted

/**
 * The picture painted so far. Depth is evaluated at the end, for visible samples only.
 *
 * An [OpaqueCanvas] shades what is painted on it. A [LayeredCanvas] keeps translucent layers, and shades at the end.
 */
internal sealed class Canvas(protected val frame: Frame, protected val counters: Counters.Builder) {
    protected val region = frame.region
    protected val width = region.width

    /** The visible opaque primitive of each sample, or [DepthTest.BACKGROUND], in rows from the top. */
    protected val indices: IntArray

    init {
        require(region.size <= Image.MAX_SAMPLES) {
            "the painter holds at most ${Image.MAX_SAMPLES} samples: ${region.size}"
        }
        indices = IntArray(region.size.toInt())
        indices.fill(DepthTest.BACKGROUND)
    }

    /** Bytes held. */
    abstract val bytes: Long

    /** Paints the primitive [index] at the columns [start] until [end] of row [y], over what [brush] is over. */
    abstract fun paint(index: Int, y: Int, start: Int, end: Int, brush: Brush)

    /** Writes colours and visible primitives of row [y], whose first sample has the array index [start]. */
    protected abstract fun finishRow(y: Int, start: Int, colors: IntArray, visible: IntArray)

    /** Passes the rows to [sink]. */
    fun finish(sink: RowSink) {
        val colors = IntArray(width)
        val depths = IntArray(width)
        val visible = IntArray(width)
        for (y in region.rowStart until region.rowEnd) {
            endIfInterrupted()
            finishRow(y, at(region.columnStart, y), colors, visible)
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

    /** Returns the array index of the sample at column [x] and row [y] of the raster. */
    protected fun at(x: Int, y: Int): Int = (y - region.rowStart) * width + (x - region.columnStart)
}
