package dev.lazyz.conformance.mutants

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.Random

/** Renderers that work in unusual ways but are correct. The suite must not fail them. */
internal object UnusualRenderers {
    /** Renderers that the suite tests in a few seconds. */
    val quick: List<() -> Renderer> = listOf(
        { unusual("random-rays", draw = ::rays) },
        { unusual("bands-of-1024-rows", Capability.CONSTANT_MEMORY, draw = ::bands) },
        { unusual("overwrites-its-rows", draw = ::overwriting) },
        { unusual("everything-twice", draw = ::twice) },
    )

    /** All of them. */
    val all: List<() -> Renderer> = quick + { unusual("threads-of-its-own", draw = ::crew) }

    private fun unusual(id: String, vararg capabilities: Capability, draw: (Frame, RowSink) -> Counters): Renderer =
        BrokenRenderer(id, capabilities.toSet()) { frame, sink ->
            require(!frame.hasTranslucency) {
                val index = frame.primitives.indexOfFirst { it.isTranslucent }
                "primitive $index is translucent; $id does not blend: make the frame opaque"
            }
            draw(frame, sink)
        }

    /** Casts a ray through each sample, in random order, and queries all primitives whose bounds contain it. */
    private fun rays(frame: Frame, sink: RowSink): Counters {
        val region = frame.region
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val image = Image(
            region,
            IntArray(region.size.toInt()) { frame.raster.background.toArgb() },
            IntArray(region.size.toInt()) { frame.raster.backgroundDepth },
            IntArray(region.size.toInt()) { DepthTest.BACKGROUND },
            Counters.NONE,
        )
        counters.peakBytes = 16L * region.size
        val near = frame.primitives.indices.filter { frame.primitives[it].meets(region) }
        val spans = Spans()
        for (i in image.argb.indices.shuffled(Random(1))) {
            cast(frame, near, spans, image, counters, i)
        }
        emit(image, sink)
        return counters.build()
    }

    private fun cast(
        frame: Frame,
        near: List<Int>,
        spans: Spans,
        image: Image,
        counters: Counters.Builder,
        sample: Int,
    ) {
        val x = image.region.columnStart + sample % image.width
        val y = image.region.rowStart + sample / image.width
        val test = frame.raster.depthTest
        var best = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
        for (index in near.shuffled(Random(sample.toLong()))) {
            spans.clear()
            frame.primitives[index].spans(y, spans)
            if ((0 until spans.count).none { x >= spans.start(it) && x < spans.end(it) }) continue
            counters.fragments++
            counters.depthEvaluations++
            val key = test.key(frame.primitives[index].depth(x, y), index)
            if (key < best) {
                best = key
                counters.depthPasses++
            }
        }
        val winner = test.indexOf(best)
        if (winner == DepthTest.BACKGROUND) return
        val fragment = Fragment()
        fragment.moveTo(x, y)
        frame.primitives[winner].shade(fragment)
        counters.shadingCalls++
        image.argb[sample] = fragment.toArgb()
        image.depth[sample] = test.depthOf(best)
        image.primitive[sample] = winner
    }

    private fun Primitive.meets(region: Region): Boolean =
        columnStart < region.columnEnd && columnEnd > region.columnStart && rowStart < region.rowEnd &&
            rowEnd > region.rowStart

    /** Renders 1,024 rows at a time, whatever the height. */
    private fun bands(frame: Frame, sink: RowSink): Counters {
        val region = frame.region
        val sum = Counters.Builder()
        for (start in region.rowStart until region.rowEnd step BAND) {
            val end = minOf(start + BAND, region.rowEnd)
            val band = frame.within(Region(region.columnStart, start, region.columnEnd, end))
            val image = ZBufferRenderer().render(band)
            emit(image, sink)
            sum.fragments += image.counters.fragments
            sum.depthEvaluations += image.counters.depthEvaluations
            sum.depthPasses += image.counters.depthPasses
            sum.shadingCalls += image.counters.shadingCalls
            sum.peakBytes = maxOf(sum.peakBytes, image.counters.peakBytes)
        }
        sum.primitives = frame.primitives.size.toLong()
        return sum.build()
    }

    /** Overwrites each row as soon as the sink has returned. */
    private fun overwriting(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame) {
            y,
            argb,
            depth,
            owner
        ->
        val rows = listOf(argb, depth, owner).map { it.copyOf() }
        sink.row(y, rows[0], rows[1], rows[2])
        for (row in rows) row.fill(GARBAGE)
    }

    /** Renders everything twice, and delivers the second picture. */
    private fun twice(frame: Frame, sink: RowSink): Counters {
        val first = ZBufferRenderer().render(frame).counters
        val second = emit(ZBufferRenderer().render(frame), sink).toBuilder()
        second.shadingCalls += first.shadingCalls
        second.depthEvaluations += first.depthEvaluations
        return second.build()
    }

    private fun crew(frame: Frame, sink: RowSink): Counters = emit(Crew(frame, 2, Tools()).render(), sink)

    private const val BAND = 1024
    private const val GARBAGE = 0x7E57
}
