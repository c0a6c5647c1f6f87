package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are right for frames, but wrong for primitives that arrive one by one, or for unsupported options. */
internal object StreamMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::drawsTheTranslucent, "draws translucent primitives as opaque ones"),
        Mistake(::deliversAgain, "delivers an image again when it is finished twice"),
        Mistake(::ignoresOptions, "ignores options that it does not support"),
        Mistake(::refusesItsOwnOptions, "refuses options that it promises to support"),
        Mistake(::continuesAfterAnError, "begins again after a primitive has thrown an Error"),
        Mistake(::refusesBeforeItLooks, "refuses a translucent primitive for an ended image as for any other"),
        Mistake(::namesTheFirst, "names another primitive than it refuses"),
        Mistake(::keepsWhatArrives, "keeps a note of each picture that it begins"),
        Mistake(::ignoresTheRegion, "draws the whole raster if primitives come one by one"),
    )

    fun namesTheFirst() = stream("stream-names-the-first") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun add(primitive: Primitive) = try {
                drawing.add(primitive)
            } catch (_: IllegalArgumentException) {
                throw IllegalArgumentException("primitive number zero is translucent: make it opaque")
            }
        }
    }

    fun continuesAfterAnError() = stream("stream-continues-after-an-error") { begin ->
        var drawing = begin()
        object : Rendering {
            override fun add(primitive: Primitive) = try {
                drawing.add(primitive)
            } catch (e: Error) {
                drawing = begin()
                throw e
            }

            override fun finish(sink: RowSink): Counters = drawing.finish(sink)
        }
    }

    fun refusesBeforeItLooks() = stream("stream-refuses-before-it-looks") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun add(primitive: Primitive) {
                require(!primitive.isTranslucent) { "primitive 0 is translucent" }
                drawing.add(primitive)
            }
        }
    }

    fun drawsTheTranslucent() = stream("stream-draws-the-translucent") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun add(primitive: Primitive) =
                drawing.add(Frame(Raster(1, 1), listOf(primitive)).asOpaque().primitives.single())
        }
    }

    fun deliversAgain() = stream("stream-delivers-again") { begin ->
        val added = ArrayList<Primitive>()
        object : Rendering {
            override fun add(primitive: Primitive) {
                require(!primitive.isTranslucent)
                added += primitive
            }

            override fun finish(sink: RowSink): Counters {
                val drawing = begin()
                added.forEach(drawing::add)
                return drawing.finish(sink)
            }
        }
    }

    fun keepsWhatArrives(): BrokenRenderer {
        val begun = ArrayList<Long>()
        return stream("stream-keeps-a-note") { begin -> begin().also { begun.add(System.nanoTime()) } }
    }

    fun ignoresTheRegion(): BrokenRenderer = WholeStream()

    private class WholeStream :
        BrokenRenderer("stream-ignores-the-region", how = { frame, sink -> ZBufferRenderer().render(frame, sink) }),
        StreamingRenderer {
        override fun begin(raster: Raster, region: Region): Rendering = ZBufferRenderer().begin(raster, raster.region)
    }

    fun ignoresOptions(): BrokenRenderer =
        object : BrokenRenderer("ignores-options", how = { frame, sink -> ZBufferRenderer().render(frame, sink) }) {
            override fun configured(options: RenderOptions): Renderer = this
        }

    fun refusesItsOwnOptions(): BrokenRenderer = object : BrokenRenderer(
        "refuses-its-own-options",
        setOf(Capability.COHERENCE),
        how = { frame, sink -> ZBufferRenderer().render(frame, sink) },
    ) {
        override fun configured(options: RenderOptions): Renderer =
            throw IllegalArgumentException("no options are supported")
    }

    internal fun stream(
        id: String,
        promises: Set<Capability> = emptySet(),
        make: (begin: () -> Rendering) -> Rendering,
    ): BrokenRenderer = BrokenStream(id, promises, make)

    private class BrokenStream(
        id: String,
        promises: Set<Capability>,
        private val make: (begin: () -> Rendering) -> Rendering,
    ) : BrokenRenderer(id, promises, how = { frame, sink -> ZBufferRenderer().render(frame, sink) }),
        StreamingRenderer {
        override fun begin(raster: Raster, region: Region): Rendering = make { ZBufferRenderer().begin(raster, region) }
    }
}
