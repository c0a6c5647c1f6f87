package dev.lazyz.strategies

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.spi.Spans

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
            for (batch in content.batches) {
                val read = batch.reader()
                for (number in 0 until batch.count step step.toInt()) if (batch.isDrawn(number)) tally.add(read(number))
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
        private val spans = region.spans()

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
}
