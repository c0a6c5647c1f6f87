package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Drawing
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.NothingThere
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that are right for frames, but wrong for primitives that arrive one by one, or for unsupported options. */
object BrokenStreams {
    fun forgetsTheLast() = stream("stream-forgets-the-last") { begin ->
        val drawing = begin()
        object : Drawing {
            private var last: Primitive? = null

            override fun add(primitive: Primitive) {
                last?.let(drawing::add)
                last = primitive
            }

            override fun finish(sink: RowSink): Counters = drawing.finish(sink)
        }
    }

    fun drawsOnOneCanvas(): BrokenRenderer {
        var common: Drawing? = null
        return stream("stream-on-one-canvas") { begin ->
            val drawing = common ?: begin().also { common = it }
            object : Drawing by drawing {
                override fun finish(sink: RowSink): Counters {
                    val first = common
                    common = null
                    return if (first === drawing) Counters.NONE else drawing.finish(sink)
                }
            }
        }
    }

    fun countsTheRefused() = stream("stream-counts-the-refused") { begin ->
        val drawing = begin()
        object : Drawing by drawing {
            override fun add(primitive: Primitive) = try {
                drawing.add(primitive)
            } catch (e: IllegalArgumentException) {
                drawing.add(NothingThere(Raster(1, 1)))
                throw e
            }
        }
    }

    fun namesTheFirst() = stream("stream-names-the-first") { begin ->
        val drawing = begin()
        object : Drawing by drawing {
            override fun add(primitive: Primitive) = try {
                drawing.add(primitive)
            } catch (_: IllegalArgumentException) {
                throw IllegalArgumentException("primitive number zero is translucent: make it opaque")
            }
        }
    }

    fun continuesAfterAnError() = stream("stream-continues-after-an-error") { begin ->
        var drawing = begin()
        object : Drawing {
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
        object : Drawing by drawing {
            override fun add(primitive: Primitive) {
                require(!primitive.isTranslucent) { "primitive 0 is translucent" }
                drawing.add(primitive)
            }
        }
    }

    fun drawsTheTranslucent() = stream("stream-draws-the-translucent") { begin ->
        val drawing = begin()
        object : Drawing by drawing {
            override fun add(primitive: Primitive) =
                drawing.add(Frame(Raster(1, 1), listOf(primitive)).asOpaque().primitives.single())
        }
    }

    fun deliversAgain() = stream("stream-delivers-again") { begin ->
        val added = ArrayList<Primitive>()
        object : Drawing {
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

    fun continuesAfterAFailure() = stream("stream-continues-after-a-failure") { begin ->
        var drawing = begin()
        object : Drawing {
            override fun add(primitive: Primitive) {
                try {
                    drawing.add(primitive)
                } catch (e: IllegalArgumentException) {
                    throw e
                } catch (e: IllegalStateException) {
                    drawing = begin()
                    throw e
                }
            }

            override fun finish(sink: RowSink): Counters = drawing.finish(sink)
        }
    }

    /** Collects all rows, and ends the image when the sink has accepted the last one. */
    fun finishesAgain() = stream("stream-finishes-again") { begin ->
        val drawing = begin()
        object : Drawing {
            private val rows = ArrayList<(RowSink) -> Unit>()
            private var counters: Counters? = null
            private var hasEnded = false

            override fun add(primitive: Primitive) {
                check(counters == null) { "finished" }
                drawing.add(primitive)
            }

            override fun finish(sink: RowSink): Counters {
                check(!hasEnded) { "finished" }
                val counted = counters ?: drawing.finish { y, argb, depth, primitive ->
                    val (colors, depths, indices) = listOf(argb, depth, primitive).map { it.copyOf() }
                    rows.add { it.row(y, colors, depths, indices) }
                }.also { counters = it }
                for (row in rows) row(sink)
                hasEnded = true
                return counted
            }
        }
    }

    fun keepsWhatArrives(): BrokenRenderer {
        val begun = ArrayList<Long>()
        return stream("stream-keeps-a-note") { begin -> begin().also { begun.add(System.nanoTime()) } }
    }

    fun storesWhatArrives() = stream("stream-stores-primitives", setOf(Capability.STREAMS_PRIMITIVES)) { begin ->
        val drawing = begin()
        val stored = ArrayList<Primitive>()
        object : Drawing {
            override fun add(primitive: Primitive) {
                drawing.add(primitive)
                stored.add(primitive)
            }

            override fun finish(sink: RowSink): Counters = drawing.finish(sink).also { stored.clear() }
        }
    }

    fun ignoresTheRegion(): BrokenRenderer = WholeStream()

    private class WholeStream :
        BrokenRenderer("stream-ignores-the-region", how = { frame, sink -> ZBuffer().render(frame, sink) }),
        StreamingRenderer {
        override fun begin(raster: Raster, region: Region): Drawing = ZBuffer().begin(raster, raster.region)
    }

    /** What arrives one by one waits for others, for each thread one, and what still waits at the end is forgotten. */
    fun forgetsWhatWaits(): BrokenRenderer = WaitingStream(1)

    private class WaitingStream(private val threads: Int) :
        BrokenRenderer(
            "stream-forgets-what-waits",
            setOf(Capability.PARALLEL),
            { WaitingStream(it.threads) },
            { frame, sink -> Tiled(RenderOptions(threads = threads)).render(frame, sink) },
        ),
        StreamingRenderer {
        override fun begin(raster: Raster, region: Region): Drawing {
            val drawing = ZBuffer().begin(raster, region)
            val waiting = ArrayList<Primitive>()
            return object : Drawing {
                override fun add(primitive: Primitive) {
                    require(!primitive.isTranslucent) { "primitive 0 is translucent: make it opaque" }
                    waiting.add(primitive)
                    if (waiting.size < threads) return
                    waiting.forEach(drawing::add)
                    waiting.clear()
                }

                override fun finish(sink: RowSink): Counters = drawing.finish(sink)
            }
        }
    }

    fun ignoresOptions(): BrokenRenderer =
        object : BrokenRenderer("ignores-options", how = { frame, sink -> ZBuffer().render(frame, sink) }) {
            override fun configured(options: RenderOptions): Renderer = this
        }

    fun refusesItsOwnOptions(): BrokenRenderer = object : BrokenRenderer(
        "refuses-its-own-options",
        setOf(Capability.COHERENCE),
        how = { frame, sink -> ZBuffer().render(frame, sink) },
    ) {
        override fun configured(options: RenderOptions): Renderer =
            throw IllegalArgumentException("no options are supported")
    }

    internal fun stream(
        id: String,
        promises: Set<Capability> = emptySet(),
        make: (begin: () -> Drawing) -> Drawing,
    ): BrokenRenderer = BrokenStream(id, promises, make)

    private class BrokenStream(
        id: String,
        promises: Set<Capability>,
        private val make: (begin: () -> Drawing) -> Drawing,
    ) : BrokenRenderer(id, promises, how = { frame, sink -> ZBuffer().render(frame, sink) }),
        StreamingRenderer {
        override fun begin(raster: Raster, region: Region): Drawing = make { ZBuffer().begin(raster, region) }
    }
}
