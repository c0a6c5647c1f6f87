package dev.lazyz.strategies

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Spans
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.setup.planar.triangleBatch

/**
 * What is cheap to know of a frame and decides what a strategy takes for it. Immutable.
 *
 * [of] looks at about [SAMPLE] primitives, evenly spaced in the order of submission: [primitiveRows] and [fragments]
 * are estimates where there are more.
 *
 * @property columns width of the picture, samples
 * @property rows height of the picture, samples
 * @property primitives number of primitives, those that cover nothing included
 * @property primitiveRows rows that primitives reach, summed over the primitives
 * @property fragments covered samples, summed over the primitives
 * @property isTranslucent whether the picture needs blending, see [Frame.hasTranslucency]
 * @property shadingCost what a colour costs, in rounds of the shader that the model was measured with (some nanoseconds each);
 *   [of] does not know it and says 1
 */
public class FrameNumbers @JvmOverloads constructor(
    public val columns: Int,
    public val rows: Int,
    public val primitives: Long,
    public val primitiveRows: Double,
    public val fragments: Double,
    public val isTranslucent: Boolean = false,
    public val shadingCost: Double = 1.0,
) {
    /** Samples of the picture. */
    public val samples: Double get() = columns.toDouble() * rows

    /** Mean number of primitives that cover a sample. */
    public val depthComplexity: Double get() = fragments / samples

    /** Samples that some primitive covers, if primitives lie at random. */
    public val visible: Double get() = samples * (1.0 - StrictMath.exp(-depthComplexity))

    override fun toString(): String =
        "FrameNumbers($columns x $rows, primitives=$primitives, primitiveRows=$primitiveRows, fragments=$fragments, " +
            "isTranslucent=$isTranslucent, shadingCost=$shadingCost)"

    public companion object {
        /** Primitives that [of] looks at, about. */
        public const val SAMPLE: Int = 1024

        /** Rows of a primitive whose spans are looked at. */
        private const val SPAN_ROWS = 4

        /** Returns the numbers of [frame]. Cost: about [SAMPLE] primitives, and what [Frame.hasTranslucency] costs. */
        @JvmStatic
        public fun of(frame: Frame): FrameNumbers {
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

    /** Adds up what primitives have within [region]. */
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

            // As far as the box around the triangle lies in the region, so does the triangle
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

            // Spans of some rows stand for those of all
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

    /** How much of an extent lies within another: grid steps, and its part of the whole. */
    private class Common(val length: Double, val share: Double)
}
