package dev.lazyz.strategies

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Spans
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch

/**
 * The properties of a frame that determine a strategy's time and memory and are cheap to obtain. Immutable.
 *
 * [of] looks at about [SAMPLE] primitives, evenly spaced in the order of submission. In frames with more primitives,
 * [primitiveRows] and [fragments] are therefore estimates.
 *
 * @property columns width of the picture, in samples
 * @property rows height of the picture, in samples
 * @property primitives number of primitives, including those that cover nothing
 * @property primitiveRows number of rows that a primitive reaches, summed over the primitives
 * @property fragments number of samples that a primitive covers, summed over the primitives
 * @property isTranslucent whether the picture needs blending, see [Frame.hasTranslucency]
 * @property shadingCost cost of one colour, relative to the shader that the model was measured with (a few nanoseconds
 *   per colour); [of] cannot determine it and sets 1
 */
internal class FrameNumbers @JvmOverloads constructor(
    val columns: Int,
    val rows: Int,
    val primitives: Long,
    val primitiveRows: Double,
    val fragments: Double,
    val isTranslucent: Boolean = false,
    val shadingCost: Double = 1.0,
) {
    /** Number of samples in the picture. */
    val samples: Double get() = columns.toDouble() * rows

    /** Mean number of primitives that cover a sample. */
    val depthComplexity: Double get() = fragments / samples

    /** Expected number of samples covered by at least one primitive, if primitives are placed at random. */
    val visible: Double get() = samples * (1.0 - StrictMath.exp(-depthComplexity))

    override fun toString(): String =
        "FrameNumbers($columns x $rows, primitives=$primitives, primitiveRows=$primitiveRows, fragments=$fragments, " +
            "isTranslucent=$isTranslucent, shadingCost=$shadingCost)"

    companion object {
        /** Approximate number of primitives that [of] looks at. */
        const val SAMPLE: Int = 1024

        /** Number of rows of a primitive whose spans are counted. */
        private const val SPAN_ROWS = 4

        /**
         * Returns the numbers of [frame]. Cost: about [SAMPLE] primitives, plus the cost of [Frame.hasTranslucency].
         */
        @JvmStatic
        fun of(frame: Frame): FrameNumbers {
            val content = frame.content
            val tally = Tally(frame.region)
            val batched = content.batches.sumOf { it.count.toLong() }
            val step = (content.singles.size + batched) / SAMPLE + 1
            for (number in content.singles.indices step step.toInt()) tally.add(content.singles[number])
            for (number in content.batches.indices) {
                val batch = content.triangleBatch(number)
                for (triangle in 0 until batch.count step step.toInt()) tally.add(batch, triangle)
            }
            return FrameNumbers(
                frame.width, frame.height, content.size.toLong(), step * tally.rows, step * tally.fragments,
                frame.hasTranslucency,
            )
        }
    }

    /** Sums rows and fragments of primitives within [region]. */
    private class Tally(private val region: Region) {
        var rows = 0.0
        var fragments = 0.0
        private val spans = Spans(region)

        fun add(batch: TriangleBatch, triangle: Int) {
            if (!batch.isDrawn(triangle)) return
            val a = batch.place(triangle, 0)
            val b = batch.place(triangle, 1)
            val c = batch.place(triangle, 2)
            val grid = batch.grid

            // Assume that the share of the triangle within the region equals the share of its bounding box
            val width = common(grid[a], grid[b], grid[c], region.columnStart, region.columnEnd)
            val height = common(grid[a + 1], grid[b + 1], grid[c + 1], region.rowStart, region.rowEnd)
            val doubled = (grid[b] - grid[a]).toDouble() * (grid[c + 1] - grid[a + 1]) -
                (grid[c] - grid[a]).toDouble() * (grid[b + 1] - grid[a + 1])
            val steps = ScreenGrid.STEPS.toDouble()
            fragments += StrictMath.abs(doubled) / (2 * steps * steps) * width.share * height.share
            rows += height.length / steps
        }

        private fun common(a: Int, b: Int, c: Int, start: Int, end: Int): Common {
            val least = minOf(a, b, c)
            val greatest = maxOf(a, b, c)
            val from = maxOf(least, start * ScreenGrid.STEPS)
            val until = minOf(greatest, end * ScreenGrid.STEPS)
            val length = maxOf(0, until - from).toDouble()
            return Common(length, if (greatest == least) 0.0 else length / (greatest - least))
        }

        fun add(primitive: Primitive) {
            val start = maxOf(primitive.rowStart, region.rowStart)
            val end = minOf(primitive.rowEnd, region.rowEnd)
            if (start >= end) return
            rows += end - start

            // Count the spans of a few rows and scale up to all rows
            val count = minOf(SPAN_ROWS, end - start)
            var covered = 0L
            for (i in 0 until count) {
                spans.clear()
                primitive.spans(start + ((2 * i + 1L) * (end - start) / (2 * count)).toInt(), spans)
                for (k in 0 until spans.count) covered += spans.end(k) - spans.start(k)
            }
            fragments += covered.toDouble() * (end - start) / count
        }
    }

    /** The part of an extent that lies within another: its length in grid steps, and its share of the whole. */
    private class Common(val length: Double, val share: Double)
}
