package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.Helpers
import dev.lazyz.Reach
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Workers
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask

/**
 * Renders a streamed frame part by part. Each part is rendered like a frame of its own, where it may be seen; a sample
 * of it replaces that of the parts before if it is nearer. The nearest fragment is a minimum of keys, so the picture
 * does not depend on how the primitives are divided into parts.
 *
 * If the picture would take more than [mostBytes], it is rendered in bands of rows, with a pass over the parts for
 * each band. Parts that do not reach a band are not read for it. While a part is rendered, another thread reads the
 * next one.
 *
 * Memory: 12 bytes a sample of a band, and three parts. Used by one thread.
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994): "sort-last", here one part after the other.
 *
 * @param mostBytes most bytes of a band, unless a row has more
 * @param renderPart renders one part
 */
internal class StreamedRendering(
    private val frame: Frame,
    private val parts: FrameParts,
    private val workers: Workers,
    private val mostBytes: Long,
    private val renderPart: (part: Frame, sink: RowSink) -> Counters,
) {
    private val test = frame.raster.depthTest
    private val counters = Counters.Builder()

    /** Renders all parts, and passes every row to [sink]. */
    fun run(sink: RowSink): Counters {
        var bytes = 0L
        for (band in bands(frame.region)) {
            val samples = SampleBuffer(frame.raster, band)
            bytes = maxOf(bytes, samples.bytes)
            inOrder(parts.filter { it.reach == null || it.reach.within(band) != null }) { part ->
                val seen = part.reach.within(band)
                if (seen != null) {
                    counters.add(renderPart(Frame(frame.raster, part.content, seen), Merge(samples, part.first, seen)))
                }
            }
            samples.handOut(sink)
        }
        counters.primitives = parts.size.toLong()
        counters.peakBytes += bytes
        return counters.build()
    }

    /** Calls [action] for each of the [parts] in order. Another thread makes them, if there is one. */
    private inline fun inOrder(parts: List<FramePart>, action: (SetUpPart) -> Unit) {
        val helpers = Helpers(workers.executor)
        var isDone = false
        try {
            var next = parts.firstOrNull()?.let { task(it) }
            for (number in parts.indices) {
                val current = checkNotNull(next)
                next = parts.getOrNull(number + 1)?.let { task(it) }
                if (next != null && workers.threads > 1) helpers.start(next::run)
                action(resultOf(current))
            }
            isDone = true
        } finally {
            helpers.end(interrupt = !isDone)
        }
    }

    private fun task(part: FramePart) = FutureTask { SetUpPart(part.first, part.content()) }

    /** A part whose primitives are in memory. */
    private class SetUpPart(val first: Int, val content: FrameContent) {
        /** A rectangle that contains all its samples. */
        val reach: Reach = reachOf(content)
    }

    /** Keeps the samples of a part that are nearer than those of the parts before. */
    private inner class Merge(private val samples: SampleBuffer, private val first: Int, private val seen: Region) :
        RowSink {
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

    /** Returns the parts of the region, from top to bottom, each small enough. */
    private fun bands(region: Region): List<Region> {
        val rows = (mostBytes / (SampleBuffer.BYTES_PER_SAMPLE * region.width)).coerceIn(1, region.height.toLong())
        return (region.rowStart until region.rowEnd step rows.toInt()).map { top ->
            val bottom = minOf(top + rows, region.rowEnd.toLong()).toInt()
            Region(region.columnStart, top, region.columnEnd, bottom)
        }
    }

    private companion object {
        /** Returns the result of [task]. If no thread has begun it, this one does it. */
        private fun resultOf(task: FutureTask<SetUpPart>): SetUpPart {
            task.run()
            try {
                return task.get()
            } catch (e: ExecutionException) {
                throw e.cause ?: e
            }
        }

        /** Returns a rectangle that contains all samples of [part]. */
        private fun reachOf(part: FrameContent): Reach {
            var left = Int.MAX_VALUE
            var top = Int.MAX_VALUE
            var right = Int.MIN_VALUE
            var bottom = Int.MIN_VALUE
            for (primitive in part.singles) {
                left = minOf(left, primitive.columnStart)
                top = minOf(top, primitive.rowStart)
                right = maxOf(right, primitive.columnEnd)
                bottom = maxOf(bottom, primitive.rowEnd)
            }
            for (number in part.batches.indices) {
                val grid = part.triangleBatch(number).grid
                for (i in grid.indices step TriangleBatch.STRIDE) {
                    val column = ScreenGrid.firstSample(grid[i])
                    val row = ScreenGrid.firstSample(grid[i + 1])
                    left = minOf(left, column)
                    top = minOf(top, row)
                    right = maxOf(right, column)
                    bottom = maxOf(bottom, row)
                }
            }
            return Reach(left, top, right, bottom)
        }
    }
}
