package dev.lazyz.conformance

import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Spans
import java.lang.ref.WeakReference
import java.util.concurrent.ConcurrentHashMap

// What is measured, not compared: memory and threads. Each measurement allows for noise many times what is usual.

/** Columns [columns] of all [rows], at [depth], red. Calls [heed] before it answers about a row. */
private class Stripe(
    private val columns: IntRange,
    private val rows: Int,
    private val depth: Int,
    private val heed: (y: Int) -> Unit = {},
) : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = rows
    override val columnStart: Int get() = columns.first
    override val columnEnd: Int get() = columns.last + 1
    override val leastDepth: Int get() = depth
    override val greatestDepth: Int get() = depth

    override fun spans(y: Int, spans: Spans) {
        heed(y)
        if (y in 0 until rows) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        if (fragment.x == columnStart) heed(fragment.y)
        fragment.setColor(1f, 0f, 0f)
    }
}

private fun fail(renderer: Renderer, what: String): Nothing = throw AssertionError("${renderer.id}: $what")

/** A counter's text without the memory, which threads multiply. */
internal fun Counters.withoutMemory(): String = toString().substringBefore(", peakBytes")

private const val WIDE = 1024
private const val FEW_ROWS = 512
private const val MANY_ROWS = 4096

/** Bytes by which a peak may grow for reasons that are no arrays of rows: half a byte for each further sample. */
private const val ALLOWANCE = (MANY_ROWS - FEW_ROWS) * WIDE / 2

/** Fails if more rows take more memory: by the renderer's own word, and by what the garbage collector leaves. */
internal fun constantMemory(renderer: Renderer) {
    // Several threads may have several blocks of rows at work, but no more of them for a higher picture
    val configured = renderer.configured(RenderOptions(threads = 2))
    val few = configured.render(stripes(FEW_ROWS)) { _, _, _, _ -> }.peakBytes
    val many = configured.render(stripes(MANY_ROWS)) { _, _, _, _ -> }.peakBytes
    if (many > few + few / 8 + Long.SIZE_BYTES) {
        fail(renderer, "peakBytes is $few for $FEW_ROWS rows of $WIDE samples, $many for $MANY_ROWS")
    }

    // A counter may be wrong, so ask the heap: of several measurements the least, since noise only adds
    if (!isCollected()) return
    val grown = (1..ATTEMPTS).minOf {
        val growth = retained(configured, MANY_ROWS) - retained(configured, FEW_ROWS)
        if (growth <= ALLOWANCE) return
        growth
    }
    fail(renderer, "$MANY_ROWS rows of $WIDE samples hold $grown bytes more of the heap than $FEW_ROWS rows")
}

private const val ATTEMPTS = 5

private fun stripes(rows: Int) =
    Frame(Raster(WIDE, rows), listOf(Stripe(0..3, rows, 1000), Stripe(2..7, rows, 2000)))

/** Bytes that are held in the middle of a rendering beyond what was held before it. */
private fun retained(renderer: Renderer, rows: Int): Long {
    val frame = stripes(rows)

    // The least of some: threads of an earlier rendering that have been joined may take a moment to let go of what they held
    val before = (1..ATTEMPTS).minOf {
        Thread.sleep(1)
        heldBytes()
    }
    var during = before
    renderer.render(frame) { y, _, _, _ -> if (y == rows / 2) during = heldBytes() }
    return during - before
}

private fun heldBytes(): Long {
    val runtime = Runtime.getRuntime()
    System.gc()
    return runtime.totalMemory() - runtime.freeMemory()
}

/** Whether the garbage collector works when it is asked to; it can be told not to. */
private fun isCollected(): Boolean {
    val garbage = WeakReference(ByteArray(1))
    System.gc()
    return garbage.get() == null
}

private const val FEW_PRIMITIVES = 16
private const val MANY_PRIMITIVES = 4096

/** Fails if thousands of hidden primitives take more memory than some. */
internal fun constantMemoryInPrimitives(renderer: Renderer) {
    val (few, many) = listOf(FEW_PRIMITIVES, MANY_PRIMITIVES).map { count ->
        val frame = Frame(Raster(8, 4), List(count) { Stripe(0..7, 4, 1000 + it) })
        renderer.render(frame) { _, _, _, _ -> }.peakBytes
    }
    if (many > few + MANY_PRIMITIVES - FEW_PRIMITIVES) {
        fail(renderer, "peakBytes is $few for $FEW_PRIMITIVES primitives, most hidden, $many for $MANY_PRIMITIVES")
    }
}

private const val SIDE = 128

/** Fails if a picture that takes a while is made by one thread alone. */
internal fun severalThreads(renderer: Renderer) {
    val configured = renderer.configured(RenderOptions(threads = 4, tileSize = 8))
    repeat(ATTEMPTS) {
        val threads = ConcurrentHashMap.newKeySet<Thread>()
        val seen = ConcurrentHashMap.newKeySet<Int>()

        // Each answer about a new row takes a millisecond, so that nobody is done before the others have begun
        val stripe = Stripe(0..<SIDE, SIDE, 1000) { y ->
            threads.add(Thread.currentThread())
            if (seen.add(y)) Thread.sleep(1)
        }
        val shaded = Stripe(0..<SIDE, SIDE, 500) {
            threads.add(Thread.currentThread())
            Thread.sleep(1)
        }
        configured.render(Frame(Raster(SIDE, SIDE), listOf(stripe, shaded))) { _, _, _, _ -> }
        if (threads.size > 1) return
    }
    fail(configured, "one thread asked all questions about a picture of $SIDE x $SIDE samples, though 4 are allowed")
}
