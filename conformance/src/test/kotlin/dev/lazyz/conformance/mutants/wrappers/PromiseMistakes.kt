package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.counting
import dev.lazyz.conformance.mutants.painting
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.lazy.LazyRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are correct but declare too many capabilities, or count incorrectly. */
internal object PromiseMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::reportsAByte, "reports one byte, whatever it holds"),
        Mistake(::holdsTheImageTwice, "promises to stay within a budget, but holds the image twice, with any budget"),
        Mistake(::reportsNoMemory, "does not report its working memory"),
        Mistake(::countsVisibleFragments, "counts visible samples as fragments"),
        Mistake(::countsRejectedTwice, "counts rejected fragments twice"),
        Mistake(::countsEveryTest, "counts every comparison as passed"),
        Mistake(::testsTheBackground, "computes depths where nothing is covered"),
        Mistake(::reportsNoLayers, "does not report the memory of translucent layers"),
        Mistake(::keepsGlass, "promises to stream primitives, but keeps those of frames that blend"),
        Mistake(::memoryGrows, "promises constant memory, but reports memory that grows with the rows"),
        Mistake(::buffersRows, "promises to stream rows, but buffers the picture"),
        Mistake(::looksAhead, "promises to stream rows, but queries the next row first"),
        Mistake(::keepsPrimitives, "promises to stream primitives, but stores and sorts all of them"),
        Mistake(::notParallel, "promises to be parallel, but uses one thread"),
        Mistake(::countsByThread, "counts work of its own for each thread"),
        Mistake(::losesCounts, "loses the counts of all threads but one"),
        Mistake(::budgetIgnored, "promises to stay within a budget, but ignores it"),
        Mistake(::noColoursWithoutBudget, "with a memory budget of 0, all colours are missing"),
    )

    fun memoryGrows() = claiming("memory-grows-with-rows", Capability.CONSTANT_MEMORY, ZBufferRenderer())

    /** Promises to stay within a budget, but holds as much as the image once more, and reports it. */
    fun holdsTheImageTwice(): BrokenRenderer = holdsTheImageTwice(RenderOptions())

    private fun holdsTheImageTwice(options: RenderOptions): BrokenRenderer = BrokenRenderer(
        "holds-the-image-twice",
        setOf(Capability.MEMORY_BUDGET),
        { holdsTheImageTwice(it) },
    ) { frame, sink ->
        val copy = IntArray(3 * frame.width * frame.height)
        HybridRenderer(options).render(frame) { y, argb, depth, primitive ->
            copy[y - frame.region.rowStart]++
            sink.row(y, argb, depth, primitive)
        }.toBuilder().apply { peakBytes += Int.SIZE_BYTES.toLong() * copy.size }.build()
    }

    fun buffersRows() = claiming("buffers-rows", Capability.STREAMS_ROWS, ZBufferRenderer())

    /** Reports the memory of opaque pictures also for translucent ones. */
    fun reportsNoLayers() = BrokenRenderer("reports-no-layers", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val counters = TiledRenderer(RenderOptions(threads = 1)).render(frame, sink).toBuilder()
        if (frame.hasTranslucency) counters.peakBytes = minOf(counters.peakBytes, 36 * frame.region.size)
        counters.build()
    }

    /** Primitives that are hidden go, unless the frame has translucent ones. */
    fun keepsGlass() = BrokenRenderer(
        "keeps-glass",
        setOf(Capability.STREAMS_PRIMITIVES, Capability.TRANSPARENCY),
    ) { frame, sink ->
        if (frame.hasTranslucency) ListsRenderer().render(frame, sink) else HybridRenderer().render(frame, sink)
    }

    /** Queries all primitives about the next row before it delivers this one. */
    fun looksAhead() = BrokenRenderer("looks-ahead", setOf(Capability.STREAMS_ROWS)) { frame, sink ->
        LazyRenderer().render(frame) { y, argb, depth, primitive ->
            if (y + 1 < frame.region.rowEnd) for (it in frame.primitives) it.spans(y + 1, Spans())
            sink.row(y, argb, depth, primitive)
        }
    }

    fun notParallel() = claiming("not-parallel", Capability.PARALLEL, ZBufferRenderer())

    fun countsByThread() = threaded("counts-by-thread") { counters, threads -> counters.depthEvaluations += threads }

    fun losesCounts() = threaded("loses-counts") { counters, threads -> counters.fragments /= threads }

    private fun threaded(id: String, threads: Int = 1, change: (Counters.Builder, Int) -> Unit): BrokenRenderer =
        BrokenRenderer(id, setOf(Capability.PARALLEL), { threaded(id, it.threads, change) }) { frame, sink ->
            TiledRenderer(RenderOptions(threads = threads, tileSize = 8)).render(frame, sink).toBuilder()
                .also { change(it, threads) }.build()
        }

    fun budgetIgnored() = claiming("budget-ignored", Capability.MEMORY_BUDGET, HybridRenderer())

    /** Without memory for a suspension, the sample stays unchanged. */
    fun noColoursWithoutBudget() = BrokenRenderer(
        "no-colours-without-budget",
        setOf(Capability.MEMORY_BUDGET),
        { if (it.memoryBudget == 0L) withoutColours() else HybridRenderer(it) },
    ) { frame, sink -> ZBufferRenderer().render(frame, sink) }

    private fun withoutColours() = painting("no-colours-without-budget") { image, _ -> image.dark() }

    private fun Image.dark() = Image(region, IntArray(argb.size), depth, primitive, counters)

    fun keepsPrimitives() = claiming("keeps-primitives", Capability.STREAMS_PRIMITIVES, HierarchicalRenderer())

    fun countsVisibleFragments() = counting("counts-visible-fragments") { fragments = it.visible.toLong() }

    fun countsRejectedTwice() = counting("counts-rejected-twice") { fragments += fragments - depthPasses }

    fun countsEveryTest() = counting("counts-every-test-as-passed") { depthPasses = 2 * fragments }

    fun testsTheBackground() = counting("tests-the-background") { depthEvaluations += it.region.size }

    fun reportsNoMemory() = counting("reports-no-memory") { peakBytes = 0 }

    fun reportsAByte() = counting("reports-a-byte") { peakBytes = minOf(peakBytes, 1) }

    private fun claiming(id: String, capability: Capability, renderer: Renderer) =
        BrokenRenderer(id, setOf(capability)) { frame: Frame, sink: RowSink -> renderer.render(frame, sink) }
}
