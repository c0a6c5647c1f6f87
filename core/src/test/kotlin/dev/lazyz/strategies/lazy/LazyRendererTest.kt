package dev.lazyz.strategies.lazy

import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.SampleScenes
import dev.lazyz.pipeline.PipelineScenes
import dev.lazyz.pipeline.PipelineScenes.usedBytes
import dev.lazyz.pipeline.Witness
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.lang.ref.WeakReference
import java.util.Random
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class LazyRendererTest {
    private val renderer = LazyRenderer()
    private val raster = Raster(8, 100)

    @Test
    fun shadesWhatIsVisibleAndNothingElse() {
        val layers = PipelineScenes.layers(raster, 20)
        val image = renderer.render(Frame(raster, layers))
        assertEquals(800, image.counters.shadingCalls)
        assertEquals(800 * 20, image.counters.fragments)
        assertEquals(8, image.counters.peakSuspensions)
        assertTrue(layers.dropLast(1).all { it.shaded.isEmpty() })
        assertEquals(800 * 20, ZBufferRenderer().render(Frame(raster, layers)).counters.shadingCalls)
    }

    @Test
    fun nothingHappensBeforeTheFirstRowIsDemanded() {
        val layers = PipelineScenes.layers(raster, 3)
        renderer.rows(Frame(raster, layers)).map { it.argb() }.drop(5)
        assertTrue(layers.all { it.cursors.isEmpty() && it.rows.isEmpty() })
    }

    @Test
    fun takingSomeRowsDoesTheWorkOfThoseRows() {
        val layers = PipelineScenes.layers(raster, 10)
        var counters = Counters.NONE
        for (row in renderer.rows(Frame(raster, layers)).take(3)) {
            assertTrue(layers.all { it.rows.size == row.y + 1 }) { "row ${row.y} is ready, and no other" }
            row.argb()
            counters = counters.plus(row.counters)
        }
        assertTrue(layers.all { it.rows == listOf(0, 1, 2) && it.depths == 24 })
        assertEquals(10, counters.primitives)
        assertEquals(240, counters.fragments)
        assertEquals(240, counters.depthEvaluations)
        assertEquals(24, counters.shadingCalls)
    }

    @Test
    fun onePixelOfARowIsOneShadingCall() {
        val layers = PipelineScenes.layers(raster, 10)
        val row = renderer.rows(Frame(raster, layers)).elementAt(5)
        assertEquals(9, row.primitive(3))
        assertEquals(Depth.FAR - 9, row.depth(3))
        assertEquals(0, row.counters.shadingCalls)

        // Computed once, even if it is read several times
        repeat(4) { row.argb(3) }
        assertEquals(1, row.counters.shadingCalls)
        assertEquals(listOf(Pair(3, 5)), layers.flatMap { it.shaded })

        // And not again when the whole row is read
        repeat(2) { row.argb() }
        row.argb(4)
        assertEquals(8, row.counters.shadingCalls)
        assertEquals(List(8) { 1 }, layers[9].shaded.groupBy { it }.map { it.value.size })
    }

    @Test
    fun aStageJoinsAtItsFirstRowAndLeavesAfterItsLast() {
        val early = Witness(Region(0, 0, 8, 30), Depth.NEAR)
        val late = Witness(Region(0, 60, 8, 100), Depth.NEAR)
        val beside = Witness(Region(0, 0, 2, 100), Depth.NEAR)
        val frame = Frame(raster, listOf(late, early, beside)).within(Region(4, 10, 8, 80))
        val bytes = renderer.rows(frame).map { it.counters.peakBytes }.toList()
        assertEquals(listOf(10), early.cursors)
        assertEquals((10 until 30).toList(), early.rows)
        assertEquals(listOf(60), late.cursors)
        assertEquals((60 until 80).toList(), late.rows)
        assertTrue(beside.cursors.isEmpty())

        // Between the two there is no stage, and less memory
        assertEquals(listOf(bytes[0]), bytes.slice((0 until 20) + (50 until 70)).distinct())
        assertEquals(1, bytes.slice(20 until 50).distinct().size)
        assertTrue(bytes[20] < bytes[0])
    }

    @Test
    fun whatIsPastCanBeCollected() {
        val rows = renderer.rows(PipelineScenes.staircase(Raster(64, 1_000), 16, 4)).iterator()
        val first = WeakReference(rows.next())
        repeat(200) { rows.next() }
        usedBytes()
        assertNull(first.get()) { "the chain holds on to a row" }
    }

    /** The table of `docs/algorithms/lazy.md`. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aBudgetIsPaidForByBeginningPrimitivesAgain() {
        val raster = Raster(64, 100)
        val counts = listOf(null, 200_000L, 100_000L, 10_000L, 0L).map { budget ->
            val layers = PipelineScenes.layers(raster, 1_000)
            val renderer = LazyRenderer(RenderOptions(memoryBudget = budget))
            val empty = renderer.render(Frame(raster, emptyList())).counters.peakBytes
            val image = renderer.render(Frame(raster, layers))
            assertEquals(listOf(6_400_000L, 6_400L), image.counters.run { listOf(depthEvaluations, shadingCalls) })
            assertTrue(layers.all { layer -> layer.rows == (0 until 100).toList() })
            Pair(layers.sumOf { it.cursors.size }, image.counters.peakBytes - empty)
        }
        val expected = listOf(1_000 to 216_064L, 9_019 to 199_864L, 56_440 to 99_968L, 99_010 to 10_000L, 100_000 to 0L)
        assertEquals(expected, counts)
    }

    @Test
    fun aPrimitiveIsSuspendedAsSoonAsThereIsRoom() {
        // The first layer ends at row 10; then its room is free for the second one
        val first = Witness(Region(0, 0, 8, 10), Depth.NEAR)
        val second = Witness(Region(0, 0, 8, 100), Depth.FAR)
        renderer.configured(RenderOptions(memoryBudget = 220)).render(Frame(raster, listOf(first, second)))
        assertEquals(listOf(0), first.cursors)
        assertEquals((0..10).toList(), second.cursors)
        assertEquals((0 until 100).toList(), second.rows)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aHundredThousandStagesNeedNoStack() {
        val frame = PipelineScenes.crowd(100_000, 3)
        val image = PipelineScenes.onASmallStack { renderer.render(frame) }
        assertEquals(300_000, image.counters.fragments)
        assertEquals(3, image.counters.shadingCalls)
        assertEquals(ZBufferRenderer().render(frame), image)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun countedMemoryIsNotLessThanWhatACrowdUses() {
        val frame = PipelineScenes.crowd(50_000, 3)
        val before = usedBytes()
        val rows = renderer.rows(frame).iterator()
        val row = rows.next()
        val used = usedBytes() - before
        assertTrue(row.counters.peakBytes in used * 9 / 10..used * 3 / 2) {
            "counted ${row.counters.peakBytes}, used $used"
        }
        assertTrue(rows.hasNext())
    }

    @Test
    fun aSequenceMayBeWalkedTwiceAndByTwoThreadsAtOnce() {
        val frame = SampleScenes.mixed(Random(4)).frame(Raster(24, 20))
        val expected = ZBufferRenderer().render(frame).argb.toList()
        val rows = renderer.rows(frame)
        val walk = Callable { rows.flatMap { it.argb().asSequence() }.toList() }
        val threads = Executors.newFixedThreadPool(2)
        try {
            for (answer in threads.invokeAll(List(4) { walk })) assertEquals(expected, answer.get())
        } finally {
            threads.shutdown()
        }

        // Interleaved on one thread
        for ((a, b) in rows.zip(rows)) assertEquals(a.argb().toList(), b.argb().toList())
    }

    @Test
    fun aStreamDoesTheWorkOfTheRowsItIsAskedFor() {
        val layers = PipelineScenes.layers(raster, 2)
        val argb = renderer.stream(Frame(raster, layers)).limit(2).map { it.argb(1) }.toList()
        assertEquals(2, argb.size)
        assertTrue(layers.all { it.rows == listOf(0, 1) })
        assertEquals(2, layers[1].shaded.size)
    }
}
