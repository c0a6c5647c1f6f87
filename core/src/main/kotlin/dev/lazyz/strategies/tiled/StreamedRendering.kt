package dev.lazyz.strategies.tiled

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FrameParts
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.pipeline.SampleBuffer
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch

/**
 * Renders a streamed frame part by part. Each part is rendered like a frame of its own, where it may be seen; a sample
 * of it replaces that of the parts before if it is nearer. The nearest fragment is a minimum of keys, so the picture
 * does not depend on how the primitives are divided into parts.
 *
 * Memory: 12 bytes a sample of the frame's region, and one part. Used by one thread.
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994): "sort-last", here one part after the other.
 *
 * @param renderPart renders one part
 */
internal class StreamedRendering(
    private val frame: Frame,
    private val renderPart: (part: Frame, sink: RowSink) -> Counters,
) {
    private val test = frame.raster.depthTest
    private val samples = SampleBuffer(frame.raster, frame.region)

    /** Renders all of [parts], and passes every row to [sink]. */
    fun run(parts: FrameParts, sink: RowSink): Counters {
        val counters = Counters.Builder()
        parts.forEach { first, part ->
            val seen = boundsOf(part)
            if (seen == null) {
                counters.primitives += part.size
            } else {
                val merge = Merge(first, seen)
                counters.add(renderPart(Frame(frame.raster, part, seen), merge))
            }
        }
        counters.peakBytes += samples.bytes
        samples.handOut(sink)
        return counters.build()
    }

    /** Keeps the samples of a part that are nearer than those of the parts before. */
    private inner class Merge(private val first: Int, private val seen: Region) : RowSink {
        override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
            val keys = samples.keys
            val start = samples.place(seen.columnStart, y)
            for (i in 0 until seen.width) {
                if (primitive[i] == DepthTest.BACKGROUND) continue
                val key = test.key(depth[i], first + primitive[i])
                if (key < keys[start + i]) {
                    keys[start + i] = key
                    samples.argb[start + i] = argb[i]
                }
            }
        }
    }

    /** Returns the part of the frame's region that can have samples of [part], or null if there is none. */
    private fun boundsOf(part: FrameContent): Region? {
        val bounds = ScreenBounds()
        for (number in part.batches.indices) bounds.include(part.triangleBatch(number))
        for (primitive in part.singles) {
            bounds.include(primitive.columnStart, primitive.rowStart, primitive.columnEnd, primitive.rowEnd)
        }
        return bounds.within(frame.region)
    }

    /** A rectangle that grows. */
    private class ScreenBounds {
        private var columnStart = Int.MAX_VALUE
        private var rowStart = Int.MAX_VALUE
        private var columnEnd = Int.MIN_VALUE
        private var rowEnd = Int.MIN_VALUE

        fun include(left: Int, top: Int, right: Int, bottom: Int) {
            columnStart = minOf(columnStart, left)
            rowStart = minOf(rowStart, top)
            columnEnd = maxOf(columnEnd, right)
            rowEnd = maxOf(rowEnd, bottom)
        }

        /** Includes all vertices of [batch]. */
        fun include(batch: TriangleBatch) {
            val grid = batch.grid
            if (grid.isEmpty()) return
            var left = Int.MAX_VALUE
            var top = Int.MAX_VALUE
            var right = Int.MIN_VALUE
            var bottom = Int.MIN_VALUE
            for (i in grid.indices step TriangleBatch.STRIDE) {
                left = minOf(left, grid[i])
                right = maxOf(right, grid[i])
                top = minOf(top, grid[i + 1])
                bottom = maxOf(bottom, grid[i + 1])
            }
            include(
                ScreenGrid.firstSample(left), ScreenGrid.firstSample(top),
                ScreenGrid.firstSample(right), ScreenGrid.firstSample(bottom),
            )
        }

        fun within(region: Region): Region? {
            val left = maxOf(columnStart, region.columnStart)
            val top = maxOf(rowStart, region.rowStart)
            val right = minOf(columnEnd, region.columnEnd)
            val bottom = minOf(rowEnd, region.rowEnd)
            return if (left < right && top < bottom) Region(left, top, right, bottom) else null
        }
    }
}
