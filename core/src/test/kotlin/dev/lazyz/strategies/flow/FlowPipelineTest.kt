package dev.lazyz.strategies.flow

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.RowSink
import dev.lazyz.SampleScenes
import dev.lazyz.pipeline.PipelineScenes
import dev.lazyz.pipeline.PipelineScenes.usedBytes
import dev.lazyz.pipeline.Witness
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.util.Random
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.cancel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.buffer
import kotlinx.coroutines.flow.flowOn
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.take
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.joinAll
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

@OptIn(kotlinx.coroutines.ExperimentalCoroutinesApi::class)
class FlowPipelineTest {
    private val pipeline = FlowPipeline()
    private val raster = Raster(8, 100)

    @Test
    fun shadesWhatIsVisibleAndNothingElse() {
        val layers = PipelineScenes.layers(raster, 20)
        val image = pipeline.render(Frame(raster, layers))
        assertEquals(800, image.counters.shadingCalls)
        assertEquals(800 * 20, image.counters.fragments)
        assertTrue(layers.dropLast(1).all { it.shaded.isEmpty() })
    }

    @Test
    fun takingSomeRowsDoesTheWorkOfThoseRows() = runBlocking {
        val layers = PipelineScenes.layers(raster, 10)
        var counters = Counters.NONE
        pipeline.rows(Frame(raster, layers)).take(3).collect { row ->
            assertTrue(layers.all { it.rows.size == row.y + 1 }) { "row ${row.y} is ready, and no other" }
            row.argb(2)
            counters = counters.plus(row.counters)
        }
        assertTrue(layers.all { it.rows == listOf(0, 1, 2) })
        assertEquals(240, counters.fragments)
        assertEquals(3, counters.shadingCalls)
    }

    @Test
    fun cancellingStopsBeforeTheNextStage() = runBlocking {
        val stop = CompletableDeferred<() -> Unit>()
        val layers = PipelineScenes.layers(raster, 50) { index, y -> if (index == 20 && y == 3) stop.getCompleted()() }
        val rows = ArrayList<Int>()
        val job = launch(start = CoroutineStart.LAZY) {
            pipeline.rows(Frame(raster, layers)).collect { rows += it.y }
        }
        stop.complete { job.cancel() }
        job.join()
        assertTrue(job.isCancelled)
        assertEquals(listOf(0, 1, 2), rows)
        for ((index, layer) in layers.withIndex()) assertEquals(if (index <= 20) 4 else 3, layer.rows.size)
    }

    @Test
    fun cancellingFromAnotherThreadStopsWithinARow() = runBlocking {
        val begun = CompletableDeferred<Unit>()
        val cancelled = CompletableDeferred<Unit>()
        var after = 0
        val layers = PipelineScenes.layers(raster, 50) { index, y ->
            // Stay in row 3 until the job is cancelled
            if (index == 20 && y == 3) {
                begun.complete(Unit)
                runBlocking { cancelled.await() }
            } else if (cancelled.isCompleted) {
                after++
            }
        }
        val job = launch(Dispatchers.Default) { pipeline.renderSuspending(Frame(raster, layers)) { _, _, _, _ -> } }
        begun.await()
        job.cancel()
        cancelled.complete(Unit)
        job.join()
        assertEquals(0, after)
        assertTrue(layers.all { it.rows.size <= 4 })
    }

    @Test
    fun aCollectorThatCancelsItselfGetsNoFurtherRow() {
        val layers = PipelineScenes.layers(raster, 5)
        var rows = 0
        assertThrows(CancellationException::class.java) {
            runBlocking {
                coroutineScope {
                    pipeline.renderSuspending(Frame(raster, layers)) { y, _, _, _ ->
                        rows++
                        if (y == 6) this.cancel()
                    }
                }
            }
        }
        assertEquals(7, rows)
        assertTrue(layers.all { it.rows.size == 7 })
    }

    @Test
    fun aSlowCollectorHoldsTheProducerBack() = runBlocking {
        val layers = PipelineScenes.layers(raster, 5)
        val gate = CompletableDeferred<Unit>()
        val waiting = CompletableDeferred<Unit>()
        val job = launch(Dispatchers.Default) {
            pipeline.rows(Frame(raster, layers)).collect { row ->
                assertTrue(layers.all { it.rows.size == row.y + 1 })
                if (row.y == 10) {
                    waiting.complete(Unit)
                    gate.await()
                }
            }
        }
        waiting.await()
        delay(50)
        assertTrue(layers.all { it.rows.size == 11 }) { "rows are made that are not collected" }
        gate.complete(Unit)
        job.join()
        assertTrue(layers.all { it.rows.size == 100 })
    }

    @Test
    fun aBufferOfTheCallersBoundsTheRowsThatWait() = runBlocking {
        val layers = PipelineScenes.layers(raster, 5)
        val gate = CompletableDeferred<Unit>()
        val colors = async {
            pipeline.rows(Frame(raster, layers)).flowOn(Dispatchers.Default).buffer(4).map { row ->
                if (row.y == 10) gate.await()
                row.argb().toList()
            }.toList().flatten()
        }
        while (layers.last().rows.size < 12) delay(1)
        delay(50)

        // One row in the collector, four in the buffer, one that did not fit into the buffer
        assertTrue(layers.all { it.rows.size <= 11 + 4 + 1 })
        gate.complete(Unit)
        assertEquals(ZBuffer().render(Frame(raster, layers)).argb.toList(), colors.await())
    }

    @Test
    fun aFlowMayBeCollectedTwiceAndByTwoCoroutinesAtOnce() = runBlocking {
        val frame = SampleScenes.mixed(Random(4)).frame(Raster(24, 20))
        val expected = ZBuffer().render(frame).argb.toList()
        val rows = pipeline.rows(frame)
        suspend fun walk(): List<Int> = rows.map {
            yield()
            it.argb().toList()
        }.toList().flatten()
        assertEquals(expected, walk())
        assertEquals(expected, walk())

        // Alternating on one thread, and concurrently on several
        for (answer in List(2) { async { walk() } }.awaitAll()) assertEquals(expected, answer)
        for (answer in List(4) { async(Dispatchers.Default) { walk() } }.awaitAll()) assertEquals(expected, answer)
    }

    @Test
    fun collectionsDoNotDisturbEachOthersRows() = runBlocking {
        val layers = PipelineScenes.layers(raster, 3)
        val rows = pipeline.rows(Frame(raster, layers))
        val other = CompletableDeferred<Unit>()

        // One stops in the middle while the other runs to the end
        val first = launch {
            var next = 0
            rows.collect {
                assertEquals(next++, it.y)
                if (it.y == 50) other.await()
            }
            assertEquals(100, next)
        }
        val second = launch {
            var next = 0
            rows.collect { assertEquals(next++, it.y) }
            assertEquals(100, next)
            other.complete(Unit)
        }
        listOf(first, second).joinAll()
        assertTrue(layers.all { it.rows.size == 200 && it.cursors == listOf(0, 0) })
    }

    @Test
    fun renderingStopsWithinARowWhenTheThreadIsInterrupted() {
        val layers = PipelineScenes.layers(raster, 50) { index, y ->
            if (index == 20 && y == 3) Thread.currentThread().interrupt()
        }
        val rows = ArrayList<Int>()
        assertThrows(InterruptedException::class.java) {
            pipeline.render(Frame(raster, layers)) { y, _, _, _ -> rows += y }
        }
        assertFalse(Thread.interrupted())
        assertEquals(listOf(0, 1, 2), rows)
        for ((index, layer) in layers.withIndex()) assertEquals(if (index <= 20) 4 else 3, layer.rows.size)
    }

    @Test
    fun renderingForCoroutinesIsTheSame() = runBlocking {
        val frame = SampleScenes.mixed(Random(9)).frame(Raster(24, 20))
        val collector = Image.Collector(frame.region)
        val counters = pipeline.renderSuspending(frame, collector)
        assertEquals(ZBuffer().render(frame), collector.toImage(counters))
        assertEquals(pipeline.render(frame).counters.toString(), counters.toString())
    }

    @Test
    fun whatTheSinkThrowsComesThrough() {
        val layers = PipelineScenes.layers(raster, 3)
        val thrown = assertThrows(IllegalStateException::class.java) {
            pipeline.render(Frame(raster, layers)) { y, _, _, _ -> check(y < 2) { "the disk is full" } }
        }
        assertEquals("the disk is full", thrown.message)
        assertTrue(layers.all(::isAtRowTwo))
    }

    private fun isAtRowTwo(layer: Witness): Boolean = layer.rows == listOf(0, 1, 2)

    @Test
    fun memoryDoesNotGrowWithTheRows() {
        val few = pipeline.render(PipelineScenes.staircase(Raster(64, 64), 16, 4), RowSink { _, _, _, _ -> })
        val frame = PipelineScenes.staircase(Raster(64, 65_536), 16, 4)
        var early = 0L
        var late = 0L
        val many = pipeline.render(frame) { y, _, _, _ ->
            if (y == 64) early = usedBytes()
            if (y == 65_535) late = usedBytes()
        }
        assertEquals(few.peakBytes - 8 * few.primitives, many.peakBytes - 8 * many.primitives)

        // The picture's colours alone would take 16 megabytes
        assertTrue(late - early < 2_000_000) { "$early bytes at row 64, $late at the last" }
    }

    @Test
    fun aHundredThousandStagesNeedNoStack() {
        val frame = PipelineScenes.crowd(100_000, 3)
        val image = PipelineScenes.onASmallStack { pipeline.render(frame) }
        assertEquals(300_000, image.counters.fragments)
        assertEquals(ZBuffer().render(frame), image)
    }
}
