package dev.lazyz.conformance.mutants

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that work in unusual ways but are correct. The suite must not fail them. */
internal object UnusualRenderers {
    /** Renderers that the suite tests in a few seconds. */
    val quick: List<() -> Renderer> = listOf(
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
