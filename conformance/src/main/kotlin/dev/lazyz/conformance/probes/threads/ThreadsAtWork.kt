package dev.lazyz.conformance.probes.threads

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.fail
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger

// These checks observe threads; they do not compare pictures.

private const val SIDE = 128
private const val ATTEMPTS = 5

/** Fails if more threads query primitives at the same time than the options allow. */
internal fun notTooManyThreads(renderer: Renderer) {
    for (allowed in 1..2) {
        val configured = renderer.configured(RenderOptions(threads = allowed, tileSize = 8))

        // A busy machine may wake up a thread late; the second duration is then long enough
        for (pause in listOf(1L, 4L)) {
            val most = mostAtOnce(configured, pause)
            if (most > allowed) fail(configured, "$most threads made queries at the same time, $allowed are allowed")
        }
    }
}

/**
 * Returns the number of threads that query a primitive at the same time. Its first answers take [pause] milliseconds
 * each.
 */
private fun mostAtOnce(configured: Renderer, pause: Long): Int {
    val pauses = AtomicInteger()
    val asking = AtomicInteger()
    val most = AtomicInteger()
    val stripe = Stripe(0..<SIDE, 0..<SIDE, 1000) {
        most.accumulateAndGet(asking.incrementAndGet(), ::maxOf)
        if (pauses.getAndIncrement() < SIDE) Thread.sleep(pause)
        asking.decrementAndGet()
    }
    configured.render(Frame(Raster(SIDE, SIDE), listOf(stripe))) { _, _, _, _ -> }
    return most.get()
}

/** Fails if a picture that takes a while is rendered by a single thread. */
internal fun severalThreads(renderer: Renderer) {
    val configured = renderer.configured(RenderOptions(threads = 4, tileSize = 8))
    repeat(ATTEMPTS) {
        val threads = ConcurrentHashMap.newKeySet<Thread>()
        val seen = ConcurrentHashMap.newKeySet<Int>()

        // Each first query of a row takes a millisecond, so that no thread finishes before the others have started
        val stripe = Stripe(0..<SIDE, 0..<SIDE, 1000) { y ->
            threads.add(Thread.currentThread())
            if (seen.add(y)) Thread.sleep(1)
        }
        val shaded = Stripe(0..<SIDE, 0..<SIDE, 500) {
            threads.add(Thread.currentThread())
            Thread.sleep(1)
        }
        configured.render(Frame(Raster(SIDE, SIDE), listOf(stripe, shaded))) { _, _, _, _ -> }
        if (threads.size > 1) return
    }
    fail(configured, "one thread made all queries for a picture of $SIDE x $SIDE samples, although 4 are allowed")
}
