package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RowSink

/**
 * Receives rows of samples without colours, and passes them on with the colours of [ShadingRate.PIXEL]. Belongs to one
 * rendering.
 */
internal class PixelShading(private val frame: Frame, private val factor: Int, private val sink: RowSink) : RowSink {
    private val width = frame.width
    private val background = frame.raster.background.toArgb()
    private val argb = Array(factor) { IntArray(width) }
    private val depths = Array(factor) { IntArray(width) }
    private val indices = Array(factor) { IntArray(width) }

    /** Recently shaded primitives, by the lower bits of their indices. */
    private val known = arrayOfNulls<Primitive>(KNOWN)
    private val knownIndices = IntArray(KNOWN) { DepthTest.BACKGROUND }
    private val fragment = Fragment()
    private var shadingCalls = 0L

    /** The samples of a pixel from its centre outward, as row times [factor] plus column. */
    private val fromCentre = (0 until factor * factor).sortedBy { square(it / factor) + square(it % factor) }

    private fun square(position: Int): Int = (2 * position + 1 - factor) * (2 * position + 1 - factor)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val number = y % factor
        depth.copyInto(depths[number], 0, 0, width)
        primitive.copyInto(indices[number], 0, 0, width)
        if (number != factor - 1 && y != frame.region.rowEnd - 1) return

        // Samples before the first row of pixels, or behind the last, are there for the filter only
        val first = maxOf(y - number, frame.region.rowStart)
        var column = frame.region.columnStart
        while (column < frame.region.columnEnd) {
            val end = minOf((column / factor + 1) * factor, frame.region.columnEnd)
            shade(first - (y - number), number + 1, column, end, y - number)
            column = end
        }
        for (row in first..y) sink.row(row, this.argb[row - (y - number)], depths[row % factor], indices[row % factor])
    }

    /** Shades the pixel with the given samples: rows of the buffers, and columns of the raster. [y] is row 0. */
    private fun shade(rowStart: Int, rowEnd: Int, columnStart: Int, columnEnd: Int, y: Int) {
        val left = columnStart - columnStart % factor
        val shift = frame.region.columnStart
        for (row in rowStart until rowEnd) argb[row].fill(UNKNOWN, columnStart - shift, columnEnd - shift)
        for (place in fromCentre) {
            val row = place / factor
            val x = left + place % factor
            if (row !in rowStart until rowEnd || x !in columnStart until columnEnd) continue
            if (argb[row][x - shift] != UNKNOWN) continue
            val index = indices[row][x - shift]
            val color = if (index == DepthTest.BACKGROUND) background else color(index, x, y + row)
            for (other in rowStart until rowEnd) {
                for (i in columnStart - shift until columnEnd - shift) {
                    if (indices[other][i] == index) argb[other][i] = color
                }
            }
        }
    }

    private fun color(index: Int, x: Int, y: Int): Int {
        val slot = index and KNOWN - 1
        if (knownIndices[slot] != index) {
            known[slot] = frame.content.primitive(index)
            knownIndices[slot] = index
        }
        shadingCalls++
        fragment.moveTo(x, y)
        checkNotNull(known[slot]).shade(fragment)
        return fragment.toArgb()
    }

    /** Returns [counters] of the rendering without colours, with the shading calls of this sink. */
    fun counted(counters: Counters): Counters = counters.toBuilder().also {
        it.shadingCalls = shadingCalls
        it.shadingStarts = shadingCalls
        it.shadingSteps = 0
        it.longestChain = 0
    }.build()

    private companion object {
        /** Number of primitives that are kept, a power of two. */
        const val KNOWN = 4096

        /** Marks a sample that is not shaded yet. An opaque primitive has no colour with alpha 0. */
        const val UNKNOWN = 0x00FFFFFF
    }
}
