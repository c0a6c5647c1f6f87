package dev.lazyz.conformance.probes.memory

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.judgement.notMeasured
import dev.lazyz.conformance.probes.failAll
import dev.lazyz.conformance.probes.renderAll
import dev.lazyz.conformance.probes.smallFrames

/** Pools and caches are full after this number of renderings of each frame, if they are fast. */
private const val FIRST = 1000
private const val FIRST_NANOSECONDS = 500_000_000L
private const val RENDERINGS = 48

/** Fails if each rendering, each failed one, or each configured renderer leaves an object on the heap. */
internal fun leavesNoObjects(renderer: Renderer, options: RenderOptions) {
    val configured = renderer.configured(options)
    fun render() {
        renderAll(configured, smallFrames)
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

/** An object takes at least 16 bytes. */
private const val LIMIT = 16L * RENDERINGS
private const val NANOSECONDS = 1_000_000L

/** A multiple of the side of small tiles, so that tiles at the right edge do not hide the difference. */
private const val NARROWER = 8
private const val WIDEST = NARROWER * (RENDERINGS * Heap.PERIODS + 1)
private const val ROWS = 8
private const val DEPTH = 1000
