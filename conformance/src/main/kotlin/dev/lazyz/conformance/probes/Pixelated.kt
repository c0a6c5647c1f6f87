package dev.lazyz.conformance.probes

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.ShadingRate
import dev.lazyz.filter.SuperSampling

/**
 * Renders pixels of [side] x [side] samples with [renderer], and returns each of them at all of its samples. Samples at
 * the border of the region that are part of no whole pixel are empty.
 */
internal class Pixelated(private val renderer: Renderer, private val side: Int, private val rate: ShadingRate) :
    Renderer by renderer {
    override fun render(frame: Frame, sink: RowSink): Counters {
        val region = frame.region
        val left = up(region.columnStart)
        val top = up(region.rowStart)
        val right = region.columnEnd / side * side
        val bottom = region.rowEnd / side * side
        if (left >= right || top >= bottom) return renderer.render(frame, sink)
        val whole = Region(left, top, right, bottom)
        val rows = Rows(region, sink)
        val counters = SuperSampling(side, rate = rate).of(frame.within(whole)).render(renderer) {
                y,
                argb,
                depth,
                index
            ->
            rows.passUntil(side * y)
            for (x in 0 until whole.width) {
                rows.set(whole.columnStart - region.columnStart + x, argb[x / side], depth[x / side], index[x / side])
            }
            rows.passUntil(side * (y + 1))
            rows.clear()
        }
        rows.passUntil(region.rowEnd)
        return counters
    }

    /** Returns the first multiple of [side] from [place] on. */
    private fun up(place: Int): Int = (place + side - 1) / side * side

    /** The row that comes next. */
    private class Rows(region: Region, private val sink: RowSink) {
        private val argb = IntArray(region.width)
        private val depth = IntArray(region.width)
        private val index = IntArray(region.width) { DepthTest.BACKGROUND }
        private var next = region.rowStart

        fun set(x: Int, color: Int, depthThere: Int, primitive: Int) {
            argb[x] = color
            depth[x] = depthThere
            index[x] = primitive
        }

        fun clear() {
            argb.fill(0)
            depth.fill(0)
            index.fill(DepthTest.BACKGROUND)
        }

        /** Passes it to the sink, again and again, until row [end] comes next. */
        fun passUntil(end: Int) {
            while (next < end) sink.row(next++, argb.clone(), depth.clone(), index.clone())
        }
    }
}
