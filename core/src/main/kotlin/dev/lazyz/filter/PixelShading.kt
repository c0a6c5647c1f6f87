package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RecentPrimitives
import dev.lazyz.RowSink

/**
 * Receives rows of samples without colours, and passes them on with the colours of [ShadingRate.PIXEL]. Footprints of
 * textures are those of pixels. The region of [frame] consists of whole pixels. Belongs to one rendering.
 */
internal class PixelShading(private val frame: Frame, private val factor: Int, private val sink: RowSink) : RowSink {
    private val width = frame.width
    private val background = frame.raster.background.toArgb()
    private val argb = Array(factor) { IntArray(width) }
    private val depths = Array(factor) { IntArray(width) }
    private val indices = Array(factor) { IntArray(width) }

    private val primitives = RecentPrimitives(frame.content)
    private val fragment = Fragment().also { it.footprintSide = factor }
    private var shadingCalls = 0L

    /** The samples of a pixel from its centre outward, as row times [factor] plus column. */
    private val fromCentre =
        (0 until factor * factor).sortedBy { square(it / factor) + square(it % factor) }.toIntArray()

    /** Which samples of the current pixel have their colour, by row times [factor] plus column. */
    private val isShaded = BooleanArray(factor * factor)

    private fun square(position: Int): Int = (2 * position + 1 - factor) * (2 * position + 1 - factor)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val number = y % factor
        depth.copyInto(depths[number], 0, 0, width)
        primitive.copyInto(indices[number], 0, 0, width)
        if (number != factor - 1) return
        val first = y - number
        for (left in 0 until width step factor) shade(left, first)
        for (row in 0 until factor) sink.row(first + row, this.argb[row], depths[row], indices[row])
    }

    /** Shades the pixel whose samples begin at column [left] of the region and row [top] of the raster. */
    private fun shade(left: Int, top: Int) {
        val single = indices[0][left]
        if (isSingle(single, left)) {
            val place = fromCentre[0]
            val color = color(single, frame.region.columnStart + left + place % factor, top + place / factor)
            for (row in argb) row.fill(color, left, left + factor)
            return
        }
        isShaded.fill(false)
        for (place in fromCentre) {
            if (isShaded[place]) continue
            val row = place / factor
            val column = left + place % factor
            val index = indices[row][column]
            val x = frame.region.columnStart + column
            val color = color(index, x, top + row)
            for (other in isShaded.indices) {
                val i = left + other % factor
                if (indices[other / factor][i] != index) continue
                argb[other / factor][i] = color
                isShaded[other] = true
            }
        }
    }

    /** Whether all samples of the pixel from column [left] of the region on show the primitive [index]. */
    private fun isSingle(index: Int, left: Int): Boolean {
        for (row in indices) for (i in left until left + factor) if (row[i] != index) return false
        return true
    }

    private fun color(index: Int, x: Int, y: Int): Int {
        if (index == DepthTest.BACKGROUND) return background
        shadingCalls++
        fragment.moveTo(x, y)
        primitives[index].shade(fragment)
        return fragment.toArgb()
    }

    /** Returns [counters] of the rendering without colours, with the shading calls of this sink. */
    fun counted(counters: Counters): Counters = counters.toBuilder().also {
        it.shadingCalls = shadingCalls
        it.shadingStarts = shadingCalls
        it.shadingSteps = 0
        it.longestChain = 0
    }.build()

    companion object {
        /** Colour, depth and primitive. */
        private const val SAMPLE_BYTES = 12L

        /** Bytes held for the samples of [frame], [factor] x [factor] a pixel. */
        fun bytes(frame: Frame, factor: Int): Long = SAMPLE_BYTES * factor * frame.width
    }
}
