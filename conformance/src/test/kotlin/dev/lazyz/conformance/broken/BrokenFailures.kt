package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Cell
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.util.concurrent.ThreadLocalRandom
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.AtomicReference

/** Renderers that clean up only after a success, or only where few look. */
internal object BrokenFailures {

    /** Interrupts its worker after a failure, and does not clear the worker's status. */
    fun leavesInterrupts() = parallel("leaves-interrupts") { frame, sink, options ->
        val worker = AtomicReference<Thread>()
        options.executor?.execute {
            worker.set(Thread.currentThread())
            runCatching { ZBuffer().render(frame) }
        }
        try {
            ZBuffer().render(frame, sink)
        } catch (e: Throwable) {
            worker.get()?.interrupt()
            throw e
        }
    }

    fun countsHalfTheDepths() = counting("counts-half-the-depths") { depthEvaluations = maxOf(depthEvaluations / 2, 0) }

    fun countsNoSelectedColours(): BrokenRenderer = countsNoSelectedColours(RenderOptions())

    private fun countsNoSelectedColours(options: RenderOptions): BrokenRenderer = BrokenRenderer(
        "counts-no-selected-colours",
        setOf(Capability.SELECTION),
        { countsNoSelectedColours(it) },
    ) { frame, sink ->
        val calls = AtomicLong()
        val counted = options.selector?.let { selector ->
            Selector { cell ->
                selector.select(
                    object : Cell by cell {
                        override fun shade(i: Int) = cell.shade(i).also { calls.incrementAndGet() }
                    },
                )
            }
        }
        val counters = Lists(options.withSelector(counted)).render(frame, sink)
        counters.toBuilder().apply { shadingCalls -= calls.get() }.build()
    }

    fun leavesTasks(): BrokenRenderer = leavesTasks(RenderOptions())

    private fun leavesTasks(options: RenderOptions): BrokenRenderer =
        BrokenRenderer("leaves-tasks", options = { leavesTasks(it) }) { frame, sink ->
            options.executor?.execute { check(frame.width > 0) }
            ZBuffer().render(frame, sink)
        }

    fun claimsTilesTwice() = parallel("claims-tiles-twice") { frame, sink, options ->
        val counters = Tiled(options).render(frame, sink)
        val isTwice = options.threads > 1 && frame.region.size > 60_000 && ThreadLocalRandom.current().nextInt(5) == 0
        if (isTwice) counters.toBuilder().apply { fragments += 64 }.build() else counters
    }

    fun stopsInterruptedWorkers() = parallel("stops-interrupted-workers") { frame, sink, options ->
        val caller = Thread.currentThread()
        val left = frame.primitives.map { primitive ->
            object : Recovered(primitive) {
                override fun spans(y: Int, spans: Spans) {
                    val thread = Thread.currentThread()
                    if (thread === caller || !thread.isInterrupted) primitive.spans(y, spans)
                }
            }
        }
        Tiled(options).render(Frame(frame.raster, left, frame.region), sink)
    }

    /** Renders by [draw] with the threads of the options. */
    private fun parallel(
        id: String,
        options: RenderOptions = RenderOptions(threads = 1),
        draw: (Frame, RowSink, RenderOptions) -> Counters,
    ): BrokenRenderer = BrokenRenderer(id, setOf(Capability.PARALLEL), { parallel(id, it, draw) }) { frame, sink ->
        require(!frame.hasTranslucency) { "does not blend: make primitive 0 opaque" }
        draw(frame, sink, options)
    }
}
