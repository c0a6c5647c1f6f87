package dev.lazyz

import dev.lazyz.filter.SuperSampling
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Sphere
import java.io.IOException
import java.io.InterruptedIOException
import java.io.UncheckedIOException
import java.util.concurrent.atomic.AtomicInteger
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.flowOn
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.take
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.runBlocking
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class RenderedRowsTest {
    private val world = scene { add(Sphere(Vector3d(0.0, 0.0, 0.0), 1.0)) }
    private val frame = world.frame(50, 300)

    @Test
    fun rowsAreThoseOfTheImage() {
        for (renderer in Renderers.builtIn) {
            val image = renderer.render(frame)
            RenderedRows.of(renderer, frame).use { rows ->
                for ((y, row) in rows.asSequence().toList().withIndex()) {
                    assertEquals(y, row.y)
                    assertArrayEquals(image.argb.copyOfRange(50 * y, 50 * y + 50), row.argb, renderer.id)
                    assertArrayEquals(image.depth.copyOfRange(50 * y, 50 * y + 50), row.depth, renderer.id)
                    assertArrayEquals(image.primitive.copyOfRange(50 * y, 50 * y + 50), row.primitive, renderer.id)
                }
                assertEquals(image.counters.shadingCalls, rows.counters.shadingCalls)
            }
        }
    }

    @Test
    fun pixelsOfSeveralSamples() {
        val sampled = SuperSampling(2).frame(world, Raster(40, 30)).within(Region(3, 4, 20, 30))
        val image = sampled.render(ZBufferRenderer())
        val rows = sampled.rows(ZBufferRenderer()).use { rows -> rows.asSequence().toList() }
        assertEquals((4 until 30).toList(), rows.map { it.y })
        assertArrayEquals(image.argb, rows.flatMap { it.argb.asList() }.toIntArray())
    }

    @Test
    fun theRenderingWaitsForTheReader() {
        val passed = AtomicInteger()
        val rows = RenderedRows.of(Counting(passed), frame)
        Thread.sleep(20)
        assertEquals(0, passed.get(), "begins only when the reader does")
        repeat(10) { rows.next() }
        while (passed.get() < 10) Thread.sleep(1)
        Thread.sleep(50)
        assertTrue(passed.get() in 10..11, "$passed")
        rows.close()
        assertTrue(passed.get() in 10..11, "$passed")
    }

    @Test
    fun closingStopsTheThreads() {
        for (reads in listOf(0, 1, 300)) {
            val rows = RenderedRows.of(Counting(AtomicInteger()), frame)
            repeat(reads) { rows.next() }
            rows.close()
            assertFalse(Counting.isRunning, "after $reads rows")
            assertThrows<IllegalStateException> { rows.hasNext() }
            assertThrows<IllegalStateException> { rows.next() }
            rows.close()
        }
        val large = RenderedRows.of(TiledRenderer(), world.frame(2000, 100_000))
        large.next()
        large.close()
    }

    @Test
    fun exceptionsReachTheReaderAfterTheRowsBefore() {
        val failure = IOException("no more")
        val failing = renderer { sink ->
            for (y in 0..2) sink.row(y, IntArray(50), IntArray(50), IntArray(50))
            throw failure
        }
        RenderedRows.of(failing, frame).use { rows ->
            repeat(3) { assertEquals(it, rows.next().y) }
            repeat(2) { assertSame(failure, assertThrows<UncheckedIOException> { rows.hasNext() }.cause) }
            assertThrows<IllegalStateException> { rows.counters }
        }
    }

    @Test
    fun aReaderThatIsInterruptedGetsAnExceptionThatJavaCanCatch() {
        val never = renderer {
            Thread.sleep(100_000)
            error("nobody has interrupted it")
        }
        RenderedRows.of(never, frame).use { rows ->
            for (read in listOf<() -> Unit>({ rows.hasNext() }, { rows.next() })) {
                Thread.currentThread().interrupt()
                val e = assertThrows<UncheckedIOException> { read() }
                assertEquals(InterruptedIOException::class.java, e.cause!!.javaClass)
                assertTrue(Thread.interrupted(), "the status is set")
            }
        }
    }

    @Test
    fun aRenderingThatIsInterruptedIsReported() {
        val interrupt = InterruptedException("by another")
        RenderedRows.of(renderer { throw interrupt }, frame).use { rows ->
            val e = assertThrows<UncheckedIOException> { rows.hasNext() }
            assertEquals(InterruptedIOException::class.java, e.cause!!.javaClass)
            assertSame(interrupt, e.cause!!.cause)
            assertFalse(Thread.interrupted(), "the reader was not interrupted")
        }
    }

    private fun renderer(rows: (RowSink) -> Nothing) = object : Renderer {
        override val id get() = "failing"
        override val summary get() = "fails"

        override fun render(frame: Frame, sink: RowSink): Counters = rows(sink)
    }

    @Test
    fun anInterruptedReaderCanClose() {
        RenderedRows.of(Counting(AtomicInteger()), frame).use { rows ->
            rows.next()
            Thread.currentThread().interrupt()
            rows.close()
            assertTrue(Thread.interrupted(), "closing keeps the interrupt")
        }
        assertFalse(Counting.isRunning)
    }

    @Test
    fun aFlowCanBeCollectedTwiceAndLeftEarly() = runBlocking {
        val passed = AtomicInteger()
        val flow = RenderedRows.flow { RenderedRows.of(Counting(passed), frame) }.flowOn(Dispatchers.IO)
        repeat(2) { assertEquals((0 until 300).toList(), flow.map { it.y }.toList()) }
        val direct = RenderedRows.flow { RenderedRows.of(Counting(passed), frame) }
        passed.set(0)
        assertEquals(listOf(0, 1, 2), direct.take(3).map { it.y }.toList())
        assertTrue(passed.get() in 3..4, "$passed")
        assertFalse(Counting.isRunning)
    }

    /** Counts the rows that its sink has taken. */
    private class Counting(private val passed: AtomicInteger) : Renderer {
        override val id get() = "counting"
        override val summary get() = "counts"

        override fun render(frame: Frame, sink: RowSink): Counters {
            isRunning = true
            try {
                return ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
                    sink.row(y, argb, depth, primitive)
                    passed.incrementAndGet()
                }
            } finally {
                isRunning = false
            }
        }

        companion object {
            @Volatile
            var isRunning = false
        }
    }
}
