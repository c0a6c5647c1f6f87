package dev.lazyz.cli.batch

import java.util.concurrent.Callable
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SharesTest {
    /** Runs [task] so many times, with its number, on several threads, and throws what one of them throws. */
    private fun together(times: Int, task: (Int) -> Unit) {
        val pool = Executors.newFixedThreadPool(8)
        try {
            pool.invokeAll(List(times) { Callable { task(it) } }).forEach { it.get() }
        } finally {
            pool.shutdownNow()
        }
    }

    @Test
    fun noMoreMemoryIsHeldThanThereIs() {
        val share = MemoryShare(100)
        val held = AtomicLong()
        val random = Random(1)
        val sizes = List(200) { random.nextLong(160) }
        together(sizes.size) { number ->
            val own = minOf(sizes[number], 100)
            share.hold(sizes[number]) {
                assertTrue(held.addAndGet(own) <= 100)
                Thread.yield()
                held.addAndGet(-own)
            }
        }
        assertEquals(0, held.get())
    }

    @Test
    fun whoAsksFirstIsServedFirst() {
        val share = MemoryShare(100)
        val isLargeServed = AtomicInteger()
        val pool = Executors.newCachedThreadPool()
        try {
            val release = CountDownLatch(1)
            val isHeld = CountDownLatch(1)
            pool.submit {
                share.hold(60) {
                    isHeld.countDown()
                    release.await()
                }
            }
            isHeld.await()
            val large = thread { share.hold(100) { isLargeServed.set(1) } }
            while (large.state != Thread.State.WAITING) Thread.sleep(1)
            val small = pool.submit<Int> { share.hold(10) { isLargeServed.get() } }
            Thread.sleep(50)
            assertFalse(small.isDone) { "a small input has overtaken a large one" }
            release.countDown()
            large.join()
            assertEquals(1, small.get())
        } finally {
            pool.shutdownNow()
        }
    }

    @Test
    fun memoryAndThreadsAreGivenBackAfterAFailure() {
        val memory = MemoryShare(10)
        val threads = ThreadShare(3)
        repeat(5) {
            runCatching { memory.hold(10) { threads.forInput { threads.forPicture<Unit> { error("bad") } } } }
        }
        assertEquals(3, memory.hold(10) { threads.forInput { threads.forPicture { it } } })
    }

    @Test
    fun noMoreThreadsWorkThanThereAreAndNoneIsIdleForASingleInput() {
        for (total in 1..5) {
            val share = ThreadShare(total)
            assertEquals(total, share.forInput { share.forPicture { it } })
            val working = AtomicInteger()
            together(60) {
                share.forInput {
                    repeat(3) {
                        share.forPicture { threads ->
                            assertTrue(working.addAndGet(threads) <= total)
                            Thread.yield()
                            working.addAndGet(-threads)
                        }
                    }
                }
            }
        }
    }
}
