package dev.lazyz.conformance.probes.threads

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.dust
import dev.lazyz.conformance.probes.fewTriangles
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread

// These checks observe threads; they do not compare pictures.

private const val SIDE = 128
private const val ATTEMPTS = 3

private const val GRAINS = 100_000
private val FEW_SAMPLES = Raster(8, 8)

/** So often, a thread may be found waiting, for example while a class is loaded. */
private const val MOST_WAITING = 4

/** Nanoseconds of processor time that a query waits for another thread, in the first attempt. */
private const val PATIENCE = 250_000L

/** Number of queries of the nearer primitive that wait: more than those that find what is covered. */
private const val MOST_WAITS = 8 * SIDE

/** What a renderer works on. Promises about threads and memory hold for all of these. */
internal enum class KindOfWork(private val need: Capability?) {
    OPAQUE(null),
    TRANSLUCENT(Capability.TRANSPARENCY),
    SELECTED(Capability.SELECTION),
    ;

    fun isFor(renderer: Renderer): Boolean = need == null || need in renderer.capabilities

    fun of(primitive: Primitive): Primitive = if (this == TRANSLUCENT) Glass(primitive) else primitive

    fun options(threads: Int): RenderOptions =
        RenderOptions(threads = threads, tileSize = 8, selector = if (this == SELECTED) SHADING_FIRST else null)

    private companion object {
        /** Shows the usual picture, but uses the cell before and after a primitive is shaded. */
        val SHADING_FIRST = Selector { cell ->
            cell.shade(0)
            cell.show(0)
        }
    }
}

/** Fails if more threads query primitives at the same time than the options allow. */
internal fun notTooManyThreads(renderer: Renderer, kind: KindOfWork) {
    for (allowed in 1..2) {
        val configured = renderer.configured(kind.options(allowed))

        // A busy machine may wake up a thread late; the second duration is then long enough
        for (pause in listOf(1L, 4L)) {
            val most = mostAtOnce(configured, kind, pause)
            if (most > allowed) fail(configured, "$most threads made queries at the same time, $allowed are allowed")
        }
    }
}

/**
 * Returns the number of threads that query a primitive at the same time. Its first answers take [pause] milliseconds
 * each.
 */
private fun mostAtOnce(configured: Renderer, kind: KindOfWork, pause: Long): Int {
    val pauses = AtomicInteger()
    val asking = AtomicInteger()
    val most = AtomicInteger()
    val stripe = Stripe(0..<SIDE, 0..<SIDE, 1000) {
        most.accumulateAndGet(asking.incrementAndGet(), ::maxOf)
        if (pauses.getAndIncrement() < SIDE) Thread.sleep(pause)
        asking.decrementAndGet()
    }
    configured.inTime(Frame(Raster(SIDE, SIDE), listOf(kind.of(stripe)))) { _, _, _, _ -> }
    return most.get()
}

/** Fails if a picture that takes a while is rendered by a single thread. */
internal fun severalThreads(renderer: Renderer, kind: KindOfWork) {
    val configured = renderer.configured(kind.options(threads = 4))
    repeat(ATTEMPTS) { attempt ->
        TryUnderWay.current?.goesOn()
        val threads = ConcurrentHashMap.newKeySet<Thread>()

        val seen = ConcurrentHashMap.newKeySet<Int>()
        val left = AtomicInteger(MOST_WAITS)

        // Queries wait for another thread, so that none finishes before the others have started
        fun await() = awaitUntil(PATIENCE shl 2 * attempt) { threads.size > 1 }
        val stripe = Stripe(0..<SIDE, 0..<SIDE, 1000) { y ->
            threads.add(Thread.currentThread())
            if (seen.add(y)) await()
        }
        val shaded = Stripe(0..<SIDE, 0..<SIDE, 500) {
            threads.add(Thread.currentThread())
            if (left.getAndDecrement() > 0) await()
        }
        configured.inTime(Frame(Raster(SIDE, SIDE), listOf(stripe, shaded).map(kind::of))) { _, _, _, _ -> }
        if (threads.size > 1) return
    }
    fail(configured, "one thread made all queries for a picture of $SIDE x $SIDE samples, although 4 are allowed")
}

/** Fails if a thread that draws a few triangles mostly waits while another one draws very many, again and again. */
internal fun waitsForNoOther(renderer: Renderer, salt: Long) {
    val configured = renderer.configured(RenderOptions(threads = 1))
    repeat(ATTEMPTS) { attempt ->
        TryUnderWay.current?.goesOn()
        val crowd = dust(salt + attempt, GRAINS)
        val busy = thread(isDaemon = true) { answer { configured.render(crowd) { _, _, _, _ -> } } }
        var drawn = salt
        val other = thread(isDaemon = true) {
            answer {
                while (busy.isAlive) configured.render(fewTriangles(drawn++, FEW_SAMPLES).frame) { _, _, _, _ -> }
            }
        }
        var looks = 0
        var waits = 0
        while (busy.isAlive) {
            Thread.sleep(1)
            looks++
            if (other.isWaiting) waits++
        }
        other.join()

        // On a busy machine a thread that could run may have to wait, too, but not in one of these states
        if (waits < MOST_WAITING || waits < looks / 2) return
    }
    fail(renderer, "a thread that draws a few triangles waits for another one that draws $GRAINS of them")
}

/** Whether the thread waits for another one. */
internal val Thread.isWaiting: Boolean
    get() = state in setOf(Thread.State.BLOCKED, Thread.State.WAITING, Thread.State.TIMED_WAITING)

/** Calls [block] for each of [cases] in a separate thread, all at the same time. Rethrows the first failure. */
internal fun <T> atOnce(cases: List<T>, block: (T) -> Unit) {
    val threads = Executors.newFixedThreadPool(cases.size) { Thread(it).apply { isDaemon = true } }
    try {
        val barrier = CyclicBarrier(cases.size)
        val results = cases.map { case ->
            threads.submit {
                barrier.await()
                block(case)
            }
        }
        for (result in results) result.get()
    } catch (e: ExecutionException) {
        throw e.cause ?: e
    } finally {
        threads.shutdownNow()
    }
}
