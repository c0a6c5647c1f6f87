package dev.lazyz.conformance.probes.memory

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.judgement.notMeasured
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.failAll
import dev.lazyz.conformance.probes.fewTriangles
import dev.lazyz.conformance.probes.renderAll
import dev.lazyz.conformance.probes.smallFrames
import dev.lazyz.conformance.probes.threads.WorkerProbe
import dev.lazyz.conformance.probes.ways
import java.lang.ref.Reference
import java.lang.ref.WeakReference
import java.util.concurrent.Executor
import java.util.concurrent.Executors

/**
 * Fails if a renderer that is still in use, or threads that render for it, hold a frame after its rendering has ended
 * or failed.
 */
internal fun keepsNothing(renderer: Renderer) {
    Heap.requireCollection()
    for (way in renderer.ways()) {
        for (end in End.entries) requireReleased(way, rendered(way, end), "the rendering $end")
    }

    // A thread that lives on, and tasks that are never begun
    val thread = Executors.newSingleThreadExecutor { work -> Thread(work, "lazyz-kept").also { it.isDaemon = true } }
    try {
        keepsNothing(renderer, thread, "a rendering by two threads has returned")
    } finally {
        thread.shutdown()
    }
    val tasks = ArrayList<Runnable>()
    keepsNothing(renderer, tasks::add, "the rendering has returned, by a task that its executor has not begun")
    Reference.reachabilityFence(tasks)
}

private fun keepsNothing(renderer: Renderer, executor: Executor, moment: String) {
    val configured = renderer.configured(RenderOptions(threads = 2, tileSize = 8, executor = executor))
    requireReleased(configured, renderedByTwo(configured), moment)
    Reference.reachabilityFence(executor)
}

private fun renderedByTwo(renderer: Renderer): List<WeakReference<Any>> {
    val frame = WorkerProbe(Thread.currentThread()) { _, _ -> }.frame
    renderer.inTime(frame) { _, _, _, _ -> }
    return listOf(frame, frame.primitives.first()).map { WeakReference(it) }
}

private fun requireReleased(renderer: Renderer, left: List<WeakReference<Any>>, moment: String) {
    if (Heap.isSoon { left.all { it.get() == null } }) return
    val kept = left.mapNotNull { it.get() }.first()
    Reference.reachabilityFence(renderer)
    fail(renderer, "a ${kept.javaClass.simpleName} is still held after $moment")
}

/** How a rendering ends. */
private enum class End(private val words: String) {
    RETURNED("has returned"),
    SINK_THREW("has failed because the sink threw"),
    PRIMITIVE_THREW("has failed because a primitive threw"),
    ;

    override fun toString(): String = words
}

/**
 * Renders a frame, and returns weak references to the frame, its primitive and its sink, which only the renderer may
 * still hold.
 */
private fun rendered(renderer: Renderer, end: End): List<WeakReference<Any>> {
    val primitive = Stripe(0..7, 0..7, 1000) { check(end != End.PRIMITIVE_THREW || it < 4) { "enough" } }
    val frame = Frame(Raster(16, 16), listOf(primitive))
    val sink = object : RowSink {
        override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) =
            check(end != End.SINK_THREW || y < 4) { "enough" }
    }
    answer { renderer.inTime(frame, sink) }
    return listOf(frame, primitive, sink).map { WeakReference(it) }
}

/** Pools and caches are full after this number of renderings of each frame, if they are fast. */
private const val FIRST = 1000
private const val FIRST_NANOSECONDS = 500_000_000L
private const val RENDERINGS = 48

/** Fails if each rendering, each failed one, or each configured renderer leaves an object on the heap. */
internal fun leavesNoObjects(renderer: Renderer, options: RenderOptions) {
    val configured = renderer.configured(options)
    var salt = 0L

    fun render() {
        // One frame has a mesh that was never rendered before
        renderAll(configured, smallFrames + fewTriangles(salt++, SMALL).frame)
        failAll(configured, smallFrames)
        renderer.configured(options.withThreads(2))
    }
    val first = System.nanoTime()
    repeat(FIRST) { if (System.nanoTime() - first < FIRST_NANOSECONDS) render() }
    doesNotGrow(renderer, "$RENDERINGS renderings of ${smallFrames.size} frames") { render() }
}

/** Fails if something remains on the heap for each size of a picture. */
internal fun leavesNoSizes(renderer: Renderer, options: RenderOptions) {
    val configured = renderer.configured(options)

    // Each picture is narrower than the one before, so what is kept for the latest one only gets smaller
    var width = WIDEST
    doesNotGrow(renderer, "$RENDERINGS renderings, each of another width,") {
        configured.inTime(Frame(Raster(width, ROWS), listOf(Stripe(0..<width, 0..<ROWS, DEPTH)))) { _, _, _, _ -> }
        width -= NARROWER
    }
}

/** Fails if each [RENDERINGS] calls of [render] leave something on the heap. */
private fun doesNotGrow(renderer: Renderer, what: String, render: () -> Unit) {
    val start = System.nanoTime()
    val growth = Heap.leastGrowth { repeat(RENDERINGS) { render() } }
    if (growth.total < LIMIT) return

    // Other threads of the process may fill the heap as steadily
    val milliseconds = (System.nanoTime() - start) / NANOSECONDS / Heap.PERIODS
    val others = Heap.leastGrowth { Thread.sleep(milliseconds) }
    if (others.total >= LIMIT / 2) notMeasured("other threads of this process hold more and more memory")
    fail(renderer, "after each $what there are $growth")
}

private val SMALL = Raster(24, 16)

/** An object takes at least 16 bytes. */
private const val LIMIT = 16L * RENDERINGS
private const val NANOSECONDS = 1_000_000L

/** A multiple of the side of small tiles, so that tiles at the right edge do not hide the difference. */
private const val NARROWER = 8
private const val WIDEST = NARROWER * (RENDERINGS * Heap.PERIODS + 1)
private const val ROWS = 8
private const val DEPTH = 1000
