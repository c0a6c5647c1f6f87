package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.counting
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.Collections
import java.util.Locale
import java.util.concurrent.ThreadLocalRandom
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.AtomicReference

/** Renderers that clean up only after a success, or only where few look. */
internal object FailureMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::leavesTasks, "leaves the executor a task that keeps the frame"),
        Mistake(::countsHalfTheDepths, "counts half of the depths that it computes"),
        Mistake(::countsNoSelectedColours, "does not count the colours that a selector asks for"),
        Mistake(::stopsInterruptedWorkers, "a worker that is interrupted leaves its rows"),
        Mistake(::claimsTilesTwice, "sometimes two threads draw the same tile"),
        Mistake(::leavesInterrupts, "an interrupt of the executor's thread if the rendering fails"),
    )

    /** Interrupts its worker after a failure. The worker sets its status again, as if the thread were its own. */
    fun leavesInterrupts() = parallel("leaves-interrupts") { frame, sink, options ->
        val worker = AtomicReference<Thread>()
        options.executor?.execute {
            worker.set(Thread.currentThread())
            try {
                ZBufferRenderer().render(frame)
            } catch (_: InterruptedException) {
                Thread.currentThread().interrupt()
            }
        }
        try {
            ZBufferRenderer().render(frame, sink)
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
        val counters = ListsRenderer(options.withSelector(counted)).render(frame, sink)
        counters.toBuilder().apply { shadingCalls -= calls.get() }.build()
    }

    fun leavesTasks(): BrokenRenderer = leavesTasks(RenderOptions())

    private fun leavesTasks(options: RenderOptions): BrokenRenderer =
        BrokenRenderer("leaves-tasks", options = { leavesTasks(it) }) { frame, sink ->
            options.executor?.execute { check(frame.width > 0) }
            ZBufferRenderer().render(frame, sink)
        }

    fun claimsTilesTwice() = parallel("claims-tiles-twice") { frame, sink, options ->
        val counters = TiledRenderer(options).render(frame, sink)
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
        TiledRenderer(options).render(Frame(frame.raster, left, frame.region), sink)
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

/** Renderers with side effects. */
internal object TidyMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::prints, "a line on standard output for each rendering"),
        Mistake(::setsEnglish, "the default locale is English, which it may be already"),
        Mistake(::renamesTheCaller, "another name for the calling thread"),
        Mistake(::addsAHook, "a shutdown hook for each rendering"),
        Mistake(::keepsAHistory, "a list of the sizes of all frames"),
    )

    private fun prints() = having("prints") { println("rendering ${it.width} x ${it.height}") }

    private fun setsEnglish() = having("sets-english") { Locale.setDefault(Locale.ENGLISH) }

    private fun renamesTheCaller() = having("renames-the-caller") { Thread.currentThread().name = "renderer" }

    private fun addsAHook() = having("adds-a-hook") { Runtime.getRuntime().addShutdownHook(Thread {}) }

    private fun keepsAHistory(): BrokenRenderer {
        val history = Collections.synchronizedList(ArrayList<String>())
        return having("keeps-a-history") { history += "${it.width} x ${it.height}" }
    }

    private fun having(id: String, block: (Frame) -> Unit) = BrokenRenderer(id) { frame, sink ->
        block(frame)
        ZBufferRenderer().render(frame, sink)
    }
}

/** Renderers that hold memory and do not report it. All other counters are correct. */
internal object MemoryMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::wholePicture, "promises constant memory, but holds the picture and reports the memory of a row"),
        Mistake(::storesPrimitives, "promises to stream primitives, but stores each in a list"),
        Mistake(::reportsTheBudgetAsKept, "ignores the memory budget, but reports that it is kept"),
        Mistake(::keepsTheLastFrame, "keeps the last frame until the next one comes"),
        Mistake(::keepsFailedFrames, "keeps frames that could not be rendered"),
    )

    private fun wholePicture() = BrokenRenderer("whole-picture", setOf(Capability.CONSTANT_MEMORY)) { frame, sink ->
        ZBufferRenderer().render(frame, sink).toBuilder().apply { peakBytes = 12L * frame.width }.build()
    }

    private fun storesPrimitives() =
        BrokenRenderer("stores-primitives", setOf(Capability.STREAMS_PRIMITIVES)) { frame, sink ->
            val hoard = ArrayList<Primitive>()
            ZBufferRenderer().render(frame.heard { hoard.add(it) }, sink).also { hoard.clear() }
        }

    /** Returns the frame with primitives that are passed to [hear] one by one. */
    private fun Frame.heard(hear: (Primitive) -> Unit): Frame {
        val primitives = object : AbstractList<Primitive>() {
            override val size: Int get() = this@heard.primitives.size

            override fun get(index: Int): Primitive = this@heard.primitives[index].also(hear)
        }
        return Frame(raster, primitives, region)
    }

    private fun reportsTheBudgetAsKept(): BrokenRenderer = reportsTheBudgetAsKept(RenderOptions())

    private fun reportsTheBudgetAsKept(options: RenderOptions): BrokenRenderer = BrokenRenderer(
        "reports-the-budget-as-kept",
        setOf(Capability.MEMORY_BUDGET),
        { reportsTheBudgetAsKept(it) },
    ) { frame, sink ->
        val image =
            HybridRenderer(RenderOptions(memoryBudget = 0)).render(Frame(frame.raster, emptyList(), frame.region))
        val most = image.counters.peakBytes + (options.memoryBudget ?: Long.MAX_VALUE / 2)
        HybridRenderer().render(frame, sink).toBuilder().apply { peakBytes = minOf(peakBytes, most) }.build()
    }

    private fun keepsTheLastFrame(): BrokenRenderer {
        val last = arrayOfNulls<Frame>(1)
        return BrokenRenderer("keeps-the-last-frame") { frame, sink ->
            last[0] = frame
            ZBufferRenderer().render(frame, sink)
        }
    }

    private fun keepsFailedFrames(): BrokenRenderer {
        val failed = ArrayList<Frame>()
        return BrokenRenderer("keeps-failed-frames") { frame, sink ->
            failed.add(frame)
            ZBufferRenderer().render(frame, sink).also { failed.remove(frame) }
        }
    }
}
