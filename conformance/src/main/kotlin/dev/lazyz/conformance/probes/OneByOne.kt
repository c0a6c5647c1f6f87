package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.UncoveredPrimitive
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.numbersIn

/**
 * Passes the primitives of a frame to [streaming] one by one. At the same time, a second image receives them in reverse
 * order, and is discarded. A translucent primitive must be refused if the renderer does not blend.
 */
internal class OneByOne(private val streaming: StreamingRenderer) : Renderer {
    override val id: String get() = streaming.id

    override val summary: String get() = streaming.summary

    override val capabilities: Set<Capability> get() = streaming.capabilities

    override fun render(frame: Frame, sink: RowSink): Counters {
        val drawing = Numbering(streaming.begin(frame.raster, frame.region))
        val beside = Numbering(streaming.begin(frame.raster, frame.region))
        for (i in frame.primitives.indices) {
            pass(frame.primitives[i], drawing)
            pass(frame.primitives[frame.primitives.size - 1 - i], beside)
        }
        beside.finish { _, _, _, _ -> }
        return drawing.finish(sink)
    }

    private fun pass(primitive: Primitive, drawing: Numbering) {
        if (!primitive.isTranslucent || Capability.TRANSPARENCY in capabilities) return drawing.add(primitive)
        val thrown = answer { drawing.add(primitive) }
        if (thrown !is IllegalArgumentException) {
            fail(this, "it does not blend, and answers a translucent primitive with ${thrown ?: "no exception"}")
        }
        if (drawing.accepted !in numbersIn(thrown.message.orEmpty())) {
            fail(this, "it refuses primitive ${drawing.accepted}, but the message does not name it: ${thrown.message}")
        }
    }

    /** Counts the primitives that were accepted. */
    private class Numbering(private val drawing: Rendering) : Rendering by drawing {
        var accepted = 0
            private set

        override fun add(primitive: Primitive) {
            drawing.add(primitive)
            accepted++
        }
    }
}

/** Passes the primitives of a frame, which [streaming] accepts, one by one. */
private class Pushing(private val streaming: StreamingRenderer) : Renderer by streaming {
    override val id: String get() = "${streaming.id}, given primitives one by one"

    override fun render(frame: Frame, sink: RowSink): Counters {
        val drawing = streaming.begin(frame.raster, frame.region)
        frame.primitives.forEach(drawing::add)
        return drawing.finish(sink)
    }
}

/** Returns this renderer, and how it renders primitives that arrive one by one, if it can. */
internal fun Renderer.ways(): List<Renderer> = listOfNotNull(this, (this as? StreamingRenderer)?.let(::Pushing))

/** Fails unless [drawing] has ended: it must refuse a primitive, and must not deliver rows again. */
internal fun hasEnded(renderer: Renderer, drawing: Rendering, why: String) {
    val answers = mapOf(
        "add" to answer { drawing.add(UncoveredPrimitive(Raster(1, 1))) },
        "add of a translucent primitive" to answer { drawing.add(Glass(UncoveredPrimitive(Raster(1, 1)))) },
        "finish" to answer { drawing.finish { _, _, _, _ -> } },
    )
    for ((call, thrown) in answers) {
        if (thrown !is IllegalStateException) {
            fail(renderer, "the image has ended $why, but '$call' throws ${thrown ?: "nothing"}")
        }
    }
}
