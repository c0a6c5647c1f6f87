package dev.lazyz.strategies.flow

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.SampleScenes
import dev.lazyz.pipeline.PipelineScenes
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.Random
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.cancel
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

@OptIn(kotlinx.coroutines.ExperimentalCoroutinesApi::class)
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class FlowRendererTest {
    private val pipeline = FlowRenderer()
    private val raster = Raster(8, 100)

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
    fun aFlowMayBeCollectedTwiceAndByTwoCoroutinesAtOnce() = runBlocking {
        val frame = SampleScenes.mixed(Random(4)).frame(Raster(24, 20))
        val expected = ZBufferRenderer().render(frame).argb.toList()
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
    fun renderingForCoroutinesIsTheSame() = runBlocking {
        val frame = SampleScenes.mixed(Random(9)).frame(Raster(24, 20))
        val collector = Image.Collector(frame.region)
        val counters = pipeline.renderSuspending(frame, collector)
        assertEquals(ZBufferRenderer().render(frame), collector.toImage(counters))
        assertEquals(pipeline.render(frame).counters.toString(), counters.toString())
    }
}
