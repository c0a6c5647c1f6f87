package dev.lazyz.server.render

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.time.Duration
import java.util.concurrent.CountDownLatch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RenderQueueTest {
    private val queue = RenderQueue(threads = 2, capacity = 2, memory = 100)
    private val begun = LinkedBlockingQueue<String>()
    private val ended = LinkedBlockingQueue<QueuedJob.Outcome>()
    private val release = CountDownLatch(1)
    private val released = AtomicInteger()
    private val file = RenderedPicture.Bytes().apply { write(ByteArray(7)) }
    private val picture = RenderedPicture(file, "image/png", "tag", emptyList(), null, false)

    @AfterEach
    fun close() = queue.close()

    private fun job(name: String, need: Long, work: () -> RenderedPicture = { picture.also { release.await() } }) =
        QueuedJob(need, { work() }, { begun.add(name) }, { released.incrementAndGet() }, { ended.add(it) })

    @Test
    fun jobsBeginInTheirOrderAsSoonAsThereIsMemory() {
        assertTrue(queue.offer(job("large", 60)))
        assertEquals("large", take(begun))
        assertTrue(queue.offer(job("next", 50)))
        assertTrue(queue.offer(job("small", 1)))
        assertEquals(listOf(2, 1), listOf(queue.waiting, queue.running))
        release.countDown()
        assertEquals(setOf("next", "small"), setOf(take(begun), take(begun)))
        repeat(3) { assertSame(picture, take(ended).picture) }
        assertTrue(picture.memory > picture.size)
        assertEquals(3 * picture.memory, queue.taken)
        queue.giveBack(3 * picture.memory)
        assertEquals(0, queue.taken)
    }

    @Test
    fun aFullQueueRefusesJobs() {
        repeat(4) { assertTrue(queue.offer(job("$it", 1))) }
        assertTrue(queue.isFull)
        assertFalse(queue.offer(job("fifth", 1)))
        release.countDown()
        repeat(4) { assertSame(picture, take(ended).picture) }
        assertFalse(queue.isFull)
    }

    @Test
    fun aCancelledJobIsInterruptedAndTheNextIsNot() {
        val reason = Problem(Problem.GONE, "gone")
        val long = job("long", 1)
        queue.offer(long)
        take(begun)
        queue.cancel(long, reason)
        assertSame(reason, take(ended).problem)
        queue.offer(job("next", 1) { picture.also { check(!Thread.currentThread().isInterrupted) } })
        assertSame(picture, take(ended).picture)
        queue.cancel(long, reason)
        assertEquals(0, ended.size)
    }

    @Test
    fun aJobThatWaitsIsTakenOut() {
        val reason = Problem(Problem.UNAVAILABLE, "late")
        val all = List(3) { job("$it", 1).also(queue::offer) }
        repeat(2) { take(begun) }
        queue.cancelIfWaiting(all[0], reason)
        queue.cancelIfWaiting(all[2], reason)
        assertSame(reason, take(ended).problem)
        assertEquals(0, queue.waiting)
        assertEquals(2, queue.running)
    }

    @Test
    fun aJobGrowsOrBeginsAgainOrIsTooLarge() {
        fun growing(name: String, need: Long) =
            QueuedJob(10, { picture.also { _ -> queue.grow(it, need) } }, { begun.add(name) }, {}, { ended.add(it) })

        queue.offer(growing("free", 90))
        assertEquals("free", take(begun))
        assertSame(picture, take(ended).picture)
        queue.giveBack(picture.memory)
        assertEquals(0, queue.taken)

        // Less is free: it waits in front of the next one, without its memory
        queue.offer(job("other", 50))
        assertEquals("other", take(begun))
        queue.offer(growing("growing", 60))
        queue.offer(job("next", 20))
        assertEquals("growing", take(begun))
        while (queue.waiting < 2) Thread.onSpinWait()
        assertEquals(50, queue.taken)
        release.countDown()
        assertEquals(setOf("growing", "next"), setOf(take(begun), take(begun)))
        repeat(3) { assertSame(picture, take(ended).picture) }
        queue.giveBack(3 * picture.memory)
        assertEquals(0, queue.taken)

        queue.offer(growing("large", 101))
        val problem = checkNotNull(take(ended).problem)
        assertEquals(413, problem.status)
        assertTrue("needs 101 bytes of memory, and there are 100" in problem.message) { problem.message }
    }

    @Test
    fun failuresBecomeProblems() {
        queue.offer(job("bug", 1) { error("bug") })
        assertEquals(Problem.BUG, take(ended).problem?.status)
        queue.offer(job("memory", 1) { throw OutOfMemoryError() })
        assertEquals(Problem.UNAVAILABLE, take(ended).problem?.status)
        val cause = IllegalStateException(OutOfMemoryError())
        queue.offer(job("loader", 1) { throw SceneFormatException("model", null, "is too large", "raise -Xmx", cause) })
        val problem = checkNotNull(take(ended).problem)
        assertEquals(Problem.UNAVAILABLE, problem.status)
        assertFalse("-Xmx" in problem.message, problem.message)
        assertEquals(0, queue.taken)
    }

    @Test
    fun aDamagedModelIsTheClientsFaultAndAFailingDiskIsNot() {
        queue.offer(job("damaged", 1) { throw SceneFormatException("model", "line 3", "is damaged") })
        val damaged = checkNotNull(take(ended).problem)
        assertEquals(Problem.UNPROCESSABLE, damaged.status)
        assertEquals("model, line 3: is damaged", damaged.message)
        queue.offer(job("disk", 1) { throw SceneReadException("/srv/models/a.obj", "cannot be read: disk failure") })
        val outcome = take(ended)
        assertEquals(Problem.BUG, outcome.problem?.status)
        assertFalse("/srv" in outcome.problem?.message.orEmpty(), outcome.problem?.message)
        assertTrue(outcome.bug is SceneReadException)
    }

    /** A thread that no interrupt ends. */
    private fun hang(): RenderedPicture {
        while (release.count > 0) runCatching { release.await() }
        return picture
    }

    @Test
    fun threadsThatDoNotReactAreReplacedAndKeepTheirMemory() = RenderQueue(2, 2, 100, SHORT).use { queue ->
        val reason = Problem(Problem.GONE, "gone")
        val bad = List(2) { job("bad", 10, ::hang).also(queue::offer) }
        repeat(2) { take(begun) }
        for (job in bad) queue.cancel(job, reason)
        repeat(2) { assertSame(reason, take(ended).problem) }
        assertEquals(listOf(2, 0, 20, 0), listOf(queue.hanging, queue.running, queue.taken.toInt(), released.get()))

        queue.offer(job("good", 1) { picture })
        assertSame(picture, take(ended).picture)
        queue.giveBack(picture.memory)
        assertFalse(queue.isStuck)
        release.countDown()
        while (queue.hanging > 0) Thread.onSpinWait()
        while (released.get() < 3) Thread.onSpinWait()
        assertEquals(0, queue.taken)
        assertNull(ended.poll())
    }

    @Test
    fun aQueueWhoseThreadsAllHangIsStuckUntilOneReturns() = RenderQueue(1, 5, 100, SHORT).use { queue ->
        val reason = Problem(Problem.GONE, "gone")
        repeat(2) {
            val bad = job("bad", 1, ::hang).also(queue::offer)
            take(begun)
            assertFalse(queue.isStuck)
            queue.cancel(bad, reason)
            assertSame(reason, take(ended).problem)
        }
        assertTrue(queue.isStuck && queue.isFull)
        release.countDown()
        while (queue.isStuck) Thread.onSpinWait()
        queue.offer(job("good", 1) { picture })
        assertSame(picture, take(ended).picture)
    }

    @Test
    fun aQueueWhoseMemoryIsHeldByThreadsThatHangIsStuck() = RenderQueue(1, 5, 100, SHORT).use { queue ->
        val bad = job("bad", 60, ::hang).also(queue::offer)
        take(begun)
        queue.offer(job("large", 50) { picture })
        assertFalse(queue.isStuck)
        queue.cancel(bad, Problem(Problem.GONE, "gone"))
        take(ended)
        assertTrue(queue.isStuck)
        release.countDown()
        assertSame(picture, take(ended).picture)
        assertFalse(queue.isStuck)
    }

    @Test
    fun closingDoesNotWaitForThreadsThatHang() {
        val queue = RenderQueue(1, 1, 100, SHORT)
        queue.offer(job("bad", 1, ::hang))
        queue.offer(job("waiting", 1))
        take(begun)
        queue.close()
        repeat(2) { assertEquals(Problem.UNAVAILABLE, take(ended).problem?.status) }
        assertEquals(1, queue.hanging)
        release.countDown()
    }

    private fun <T : Any> take(from: LinkedBlockingQueue<T>): T =
        checkNotNull(from.poll(300, TimeUnit.SECONDS)) { "nothing happens" }

    private companion object {
        /** Nothing that must succeed has only this time. */
        val SHORT: Duration = Duration.ofMillis(20)
    }
}
