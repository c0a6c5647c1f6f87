package dev.lazyz.strategies.tiled

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.util.concurrent.CountDownLatch
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Threads work concurrently, stop when they must, and have ended afterwards. */
class TiledThreadsTest {
    private val raster = Raster(64, 64)

    private fun tiled(threads: Int) = TiledRenderer(Coherence.DIRECT, threads, 16)

    private fun frame(onShade: (x: Int, y: Int) -> Unit) = Frame(raster, listOf(Probe(raster.region, onShade)))

    @AfterEach
    fun noThreadIsLeft() {
        val working = Thread.getAllStackTraces().filter { (thread, frames) ->
            thread.name.startsWith("lazyz-") && frames.any { it.className.startsWith("dev.lazyz.strategies.") }
        }
        assertEquals(emptySet<Thread>(), working.keys)
        assertFalse(Thread.interrupted()) { "the test's thread is left interrupted" }
    }

    @Test
    fun tilesAreShadedAtTheSameTime() {
        // The first samples of four tiles wait for each other
        val barrier = CyclicBarrier(4)
        tiled(4).render(frame { x, y -> if (y == 0 && x % 16 == 0) barrier.await() })
    }

    @Test
    fun theNextBandIsRenderedWhileOneIsHandedOut() {
        val begun = CountDownLatch(1)
        tiled(2).render(frame { _, y -> if (y == 16) begun.countDown() }) { y, _, _, _ ->
            if (y == 0) begun.await()
        }
    }

    @Test
    fun noMoreThreadsAreStartedThanThereAreTiles() {
        val tasks = AtomicInteger()
        val executor = Executor { tasks.incrementAndGet() }
        val small = Frame(Raster(17, 16), listOf(Probe(Region(0, 0, 17, 16)) { _, _ -> }))
        TiledRenderer(RenderOptions(threads = 50, tileSize = 16, executor = executor)).render(small)
        assertEquals(1, tasks.get())
    }

    @Test
    fun anExceptionInAPrimitiveReachesTheCaller() {
        val exception = UnsupportedOperationException("spans")
        val broken = object : Primitive {
            override val rowStart = 0
            override val rowEnd = 64
            override val columnStart = 0
            override val columnEnd = 64
            override fun spans(y: Int, spans: Spans) = if (y == 50) throw exception else spans.add(0, 64)
            override fun depth(x: Int, y: Int) = 0
            override fun shade(fragment: Fragment) = Unit
        }
        for (threads in listOf(1, 4)) {
            val rows = ArrayList<Int>()
            val thrown = assertThrows(UnsupportedOperationException::class.java) {
                tiled(threads).render(Frame(raster, listOf(broken))) { y, _, _, _ -> rows += y }
            }
            assertSame(exception, thrown)
            assertEquals(rows.indices.toList(), rows)
            assertTrue(rows.size <= 48)
        }
    }

    @Test
    fun anExceptionInTheSinkStopsAllThreads() {
        val shaded = AtomicInteger()
        val high = Raster(64, 6400)
        val exception = RuntimeException("sink")
        val thrown = assertThrows(RuntimeException::class.java) {
            val probe = Probe(high.region) { _, _ -> shaded.incrementAndGet() }
            tiled(3).render(Frame(high, listOf(probe))) { y, _, _, _ -> if (y == 5) throw exception }
        }
        assertSame(exception, thrown)

        // At most the bands that may be in progress at a time
        assertTrue(shaded.get() <= 64 * 16 * 4) { "$shaded samples were shaded" }
    }

    @Test
    fun interruptingTheCallerStopsAllThreads() {
        for (threads in listOf(1, 3)) {
            val caller = Thread.currentThread()
            val rows = AtomicInteger()
            val shadedAfter = AtomicInteger()
            assertThrows(InterruptedException::class.java) {
                tiled(threads).render(
                    frame { x, y ->
                        // From any thread that is working there
                        if (x == 20 && y == 20) caller.interrupt()
                        if (!caller.isInterrupted) return@frame
                        shadedAfter.incrementAndGet()

                        // The caller may have to wait for a processor before it can notice
                        if (Thread.currentThread() !== caller) LockSupport.parkNanos(5_000_000)
                    },
                ) { _, _, _, _ -> rows.incrementAndGet() }
            }
            assertTrue(rows.get() <= 16) { "$rows rows were handed out" }
            assertTrue(shadedAfter.get() <= 64 * 16) { "$shadedAfter samples were shaded" }
            assertFalse(Thread.interrupted())
        }
    }

    /** Somebody else interrupts the threads of the executor: that is not an interrupt of the caller. */
    @Test
    fun anInterruptedThreadOfTheExecutorDoesNotEndTheRendering() {
        val isKept = CountDownLatch(2)
        val executor = Executor { task ->
            val run = {
                Thread.currentThread().interrupt()
                task.run()
                if (Thread.interrupted()) isKept.countDown()
            }
            Thread(run).apply { isDaemon = true }.start()
        }
        val renderer = TiledRenderer(RenderOptions(threads = 3, tileSize = 16, executor = executor))
        val rows = ArrayList<Int>()
        renderer.render(frame { _, _ -> }) { y, _, _, _ ->
            // The threads of the executor have nothing to do, and wait
            if (y % 16 == 0) LockSupport.parkNanos(20_000_000)
            rows += y
        }
        assertEquals((0 until 64).toList(), rows)

        // The status of the threads is left as it was
        isKept.await()
    }
}
