package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted

/** A canvas for opaque primitives: colour and primitive of each sample. What is painted is shaded immediately. */
internal class OpaqueCanvas(frame: Frame, counters: Counters.Builder) : Canvas(frame, counters) {
    private val fragment = Fragment()
    private val argb = IntArray(indices.size)

    init {
        argb.fill(frame.raster.background.toArgb())
    }

    override val bytes: Long get() = argb.bytes + indices.bytes + Int.SIZE_BYTES * 3L * width

    override fun paint(index: Int, y: Int, start: Int, end: Int, brush: Brush) {
        var at = at(start, y)
        for (x in start until end) {
            if (brush.isOver(x, y, index, indices[at])) paint(x, y, at, index)
            at++
        }
    }

    private fun paint(x: Int, y: Int, at: Int, index: Int) {
        endIfInterrupted()
        counters.depthPasses++
        counters.shadingCalls++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        argb[at] = fragment.toArgb()
        indices[at] = index
    }

    override fun finishRow(y: Int, start: Int, colors: IntArray, visible: IntArray) {
        argb.copyInto(colors, 0, start, start + width)
        indices.copyInto(visible, 0, start, start + width)
    }
}
