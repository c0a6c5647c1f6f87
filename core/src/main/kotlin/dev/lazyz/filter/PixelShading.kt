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
    private val fromCentre = (0 until factor * factor).sortedBy { square(it / factor) + square(it % factor) }

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
        for (row in 0 until factor) argb[row].fill(UNKNOWN, left, left + factor)
        for (place in fromCentre) {
            val row = place / factor
            val column = left + place % factor
            if (argb[row][column] != UNKNOWN) continue
            val index = indices[row][column]
            val x = frame.region.columnStart + column
            val color = if (index == DepthTest.BACKGROUND) background else color(index, x, top + row)
            for (other in 0 until factor) {
                for (i in left until left + factor) if (indices[other][i] == index) argb[other][i] = color
            }
        }
    }

    private fun color(index: Int, x: Int, y: Int): Int {
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
        /** Marks a sample that is not shaded yet. Only a background can have this colour, which does no harm. */
        private const val UNKNOWN = 0x00FFFFFF

        /** Colour, depth and primitive. */
        private const val SAMPLE_BYTES = 12L

        /** Bytes held for the samples of [frame], [factor] x [factor] a pixel. */
        fun bytes(frame: Frame, factor: Int): Long = SAMPLE_BYTES * factor * frame.width
    }
}
