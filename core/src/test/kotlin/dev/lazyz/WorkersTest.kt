package dev.lazyz

import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import java.lang.ref.WeakReference
import java.util.Collections
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.Executor
import java.util.concurrent.Executors
import java.util.concurrent.ForkJoinPool
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.atomic.AtomicInteger
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The calling thread and helpers from any executor do each part of the work once, and stop when they must. */
class WorkersTest {
    /** Executors with and without threads: of the library, of the JDK, in the caller, never, and refusing. */
    private val executors: Map<String, Executor> = mapOf(
        "library" to LibraryThreads,
        "common pool" to ForkJoinPool.commonPool(),
        "the calling thread" to Executor { it.run() },
        "never runs a task" to Executor { },
        "rejects" to Executor { throw RejectedExecutionException("full") },
        "no memory for a thread" to Executor { throw OutOfMemoryError("unable to create native thread") },
    )

    @Test
    fun eachNumberIsTakenOnceWithAnyExecutor() {
        for ((name, executor) in executors) {
            val taken = Collections.synchronizedList(ArrayList<Int>())
            RenderOptions(threads = 4, executor = executor).inParallel(100) { taken += it }
            assertEquals((0 until 100).toList(), taken.sorted(), name)
        }
    }

    @Test
    fun severalThreadsTakePart() {
        // Each number waits for the others
        val barrier = CyclicBarrier(4)
        RenderOptions(threads = 4).inParallel(4) { barrier.await() }
    }

    @Test
    fun anInterruptedCallerBeginsNothing() {
        Thread.currentThread().interrupt()
        assertThrows(InterruptedException::class.java) { RenderOptions(threads = 1).inParallel(1) { error("begun") } }
        assertFalse(Thread.currentThread().isInterrupted)
    }

    @Test
    fun theFirstExceptionReachesTheCallerAndTheRestIsSkipped() {
        for ((name, executor) in executors) {
            val planted = StackOverflowError(name)
            val after = AtomicInteger()
            val thrown = assertThrows(StackOverflowError::class.java) {
                Workers(2, executor).forEach(100_000, Checkpoint.NONE) { number, _ ->
                    if (number == 3) throw planted

                    // A busy machine may let the thread that throws wait, so the other one must not be through with all
                    if (after.incrementAndGet() > 50_000) Thread.sleep(1)
                }
            }
            assertSame(planted, thrown)
            assertTrue(after.get() < 90_000, name)
        }
    }

    @Test
    fun aHelperThatBeganIsWaitedForEvenIfItsExecutorThrows() {
        for (failure in listOf(RejectedExecutionException(), OutOfMemoryError(), IllegalStateException())) {
            val caller = Thread.currentThread()
            val begun = CountDownLatch(1)
            val working = AtomicInteger()
            val executor = Executor { task ->
                Thread(task).start()
                begun.await()
                throw failure
            }
            val run = {
                Workers(2, executor).forEach(2, Checkpoint.NONE) { _, _ ->
                    if (Thread.currentThread() !== caller) {
                        working.incrementAndGet()
                        begun.countDown()
                        Thread.sleep(200)
                        working.decrementAndGet()
                    }
                }
            }
            if (failure is IllegalStateException) {
                assertSame(
                    failure,
                    assertThrows(failure.javaClass) {
                        run()
                    }
                )
            } else {
                run()
            }
            assertEquals(0, working.get(), "$failure")
        }
    }

    /** The calling thread waits for a call that only a checkpoint ends. */
    @Test
    fun anInterruptOfTheWaitingCallerEndsTheCallsOfOtherThreads() {
        val caller = Thread.currentThread()
        val hasBegun = CountDownLatch(1)
        val working = AtomicInteger()
        assertThrows(InterruptedException::class.java) {
            Workers(2, LibraryThreads).forEach(2, Checkpoint.CALLER) { _, checkpoint ->
                if (Thread.currentThread() === caller) return@forEach hasBegun.await()
                working.incrementAndGet()
                hasBegun.countDown()
                try {
                    while (caller.state != Thread.State.WAITING) checkpoint.pass()
                    caller.interrupt()
                    while (true) checkpoint.pass()
                } finally {
                    working.decrementAndGet()
                }
            }
        }
        assertFalse(Thread.interrupted(), "the status is cleared")
        assertEquals(0, working.get())
    }

    @Test
    fun anInterruptIsKeptIfAnotherExceptionIsThrown() {
        val planted = IllegalStateException()
        val caller = Thread.currentThread()
        val helper = CompletableFuture<Thread>()
        val hasBegun = CountDownLatch(1)
        val thrown = assertThrows(IllegalStateException::class.java) {
            Workers(2, LibraryThreads).forEach(2, Checkpoint.CALLER) { _, checkpoint ->
                if (Thread.currentThread() !== caller) {
                    // After a failure, the caller would not begin
                    hasBegun.await()
                    helper.complete(Thread.currentThread())
                    throw planted
                }
                hasBegun.countDown()

                // Until the other thread has failed, and waits for more work
                while (helper.get().state != Thread.State.TIMED_WAITING) Thread.onSpinWait()
                caller.interrupt()
                checkpoint.pass()
            }
        }
        assertSame(planted, thrown)
        assertTrue(Thread.interrupted(), "the status is kept")
    }

    @Test
    fun aTaskThatRunsLateDoesNothing() {
        val tasks = ArrayList<Runnable>()
        val calls = AtomicInteger()
        Workers(3, tasks::add).forEach(5, Checkpoint.NONE) { _, _ -> calls.incrementAndGet() }
        assertEquals(2, tasks.size)
        tasks.forEach { task -> Thread(task).apply { start() }.join() }
        assertEquals(5, calls.get())
    }

    @Test
    fun aTaskThatWaitsInItsQueueRefersToNothing() {
        val tasks = ArrayList<Runnable>()
        val data = usedByTasks(tasks)
        while (data.get() != null) {
            System.gc()
            Thread.sleep(10)
        }
        assertEquals(1, tasks.size)
    }

    private fun usedByTasks(tasks: MutableList<Runnable>): WeakReference<ByteArray> {
        val data = ByteArray(1 shl 20)
        Workers(2, tasks::add).forEach(2, Checkpoint.NONE) { number, _ -> data[number] = 1 }
        return WeakReference(data)
    }

    @Test
    fun anInterruptForTheWorkDoesNotReachTheExecutorsNextTask() {
        val executor = Executors.newSingleThreadExecutor()
        try {
            val begun = CountDownLatch(1)
            val helpers = Helpers(executor)
            helpers.start {
                begun.countDown()
                assertThrows(InterruptedException::class.java) { Thread.sleep(600_000) }
                Thread.currentThread().interrupt()
            }
            begun.await()
            helpers.end(interrupt = true)
            assertFalse(executor.submit<Boolean> { Thread.currentThread().isInterrupted }.get())
        } finally {
            executor.shutdownNow()
        }
    }

    @Test
    fun anInterruptOfTheCallerStaysSet() {
        Thread.currentThread().interrupt()
        Workers(4, LibraryThreads).forEach(100, Checkpoint.NONE) { _, _ -> Thread.onSpinWait() }
        assertTrue(Thread.interrupted())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aFrameAndItsPictureAreMadeByTheCallersThreads() {
        val scene = Scene(listOf(SampleScenes.sheet(200) { x, y, axis -> listOf(x, y, (x + y) % 7)[axis] }))
        val raster = Raster(96, 96)
        val expected = ZBufferRenderer().render(scene.frame(raster))
        for ((name, executor) in executors) {
            val options = RenderOptions(threads = 3, tileSize = 16, executor = executor)
            assertEquals(expected, TiledRenderer(options).render(scene.frame(raster, options)), name)
        }

        // With one thread, the executor gets no task
        val none = Executor { throw AssertionError("no other thread is permitted") }
        val alone = RenderOptions(threads = 1, executor = none)
        assertEquals(expected, TiledRenderer(alone).render(scene.frame(raster, alone)))
    }
}
