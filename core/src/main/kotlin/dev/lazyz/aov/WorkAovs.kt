package dev.lazyz.aov

import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.ShadingObserver
import dev.lazyz.Spans
import dev.lazyz.endIfInterrupted
import dev.lazyz.filter.SampledFrame
import java.util.concurrent.atomic.AtomicIntegerArray

/** The AOVs of work: how often something happens at the samples of a pixel. */
internal object WorkAovs {
    /** Counts the fragments of [sampled]. */
    fun overdraw(sampled: SampledFrame): AovImage {
        val counts = IntArray(Math.toIntExact(sampled.pixels.size))
        val spans = Spans()
        sampled.frame.content.forEachDrawn { primitive ->
            endIfInterrupted()
            addFragments(sampled, primitive, spans, counts)
        }
        return AovImage(Aov.OVERDRAW, sampled.pixels, counts, samplesPerPixel(sampled))
    }

    private fun samplesPerPixel(sampled: SampledFrame) = sampled.sampling.factor * sampled.sampling.factor

    private fun addFragments(sampled: SampledFrame, primitive: Primitive, spans: Spans, counts: IntArray) {
        val pixels = sampled.pixels
        val factor = sampled.sampling.factor
        val firstColumn = pixels.columnStart * factor
        val endColumn = pixels.columnEnd * factor
        if (primitive.columnStart >= endColumn || primitive.columnEnd <= firstColumn) return
        val end = minOf(primitive.rowEnd, pixels.rowEnd * factor)
        for (y in maxOf(primitive.rowStart, pixels.rowStart * factor) until end) {
            spans.clear()
            primitive.spans(y, spans)
            val row = (y / factor - pixels.rowStart) * pixels.width - pixels.columnStart
            for (i in 0 until spans.count) {
                // The part of the span in each pixel
                var x = maxOf(spans.start(i), firstColumn)
                val until = minOf(spans.end(i), endColumn)
                while (x < until) {
                    val next = minOf((x / factor + 1) * factor, until)
                    val at = row + x / factor
                    counts[at] = minOf(counts[at].toLong() + (next - x), Int.MAX_VALUE.toLong()).toInt()
                    x = next
                }
            }
        }
    }

    /** Counts the shading calls of [renderer] in another rendering of [sampled]. */
    fun shadingCalls(sampled: SampledFrame, renderer: Renderer): AovImage {
        val pixels = sampled.pixels
        val factor = sampled.sampling.factor
        val counts = AtomicIntegerArray(Math.toIntExact(pixels.size))
        val observer = ShadingObserver { x, y, _ ->
            val column = x / factor
            val row = y / factor
            if (pixels.contains(column, row)) {
                counts.incrementAndGet((row - pixels.rowStart) * pixels.width + column - pixels.columnStart)
            }
        }
        sampled.observed(observer).render(renderer) { _, _, _, _ -> }
        return AovImage(Aov.SHADING_CALLS, pixels, IntArray(counts.length()) { counts[it] }, samplesPerPixel(sampled))
    }
}
