package dev.lazyz.strategies.scanline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.Stacks
import dev.lazyz.strategies.Submission
import dev.lazyz.strategies.Weave
import dev.lazyz.strategies.counted
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ScanlineRendererTest {
    private fun counted(frame: Frame) = ScanlineRenderer().counted(frame)

    @Test
    fun layersApartInDepthCostNoComparison() {
        // Only the depths of the output are evaluated
        val counters = counted(Stacks.layers(Raster(256, 64), 100, Submission.BACK_TO_FRONT))
        assertEquals(100L * 256 * 64, counters.fragments)
        assertEquals(256L * 64, counters.depthEvaluations)
    }

    @Test
    fun layersThatOverlapInDepthAreComparedOnceARow() {
        val counters = counted(Stacks.layers(Raster(256, 64), 100, Submission.BACK_TO_FRONT, steepness = 20.0))
        assertEquals(100L * 256 * 64, counters.fragments)
        val perFragment = counters.depthEvaluations.toDouble() / counters.fragments
        assertTrue(perFragment < 0.03, "$perFragment depth evaluations a fragment")
    }

    @Test
    fun comparingGrowsAboutLinearlyWithTheActiveSpans() {
        // Pyramids of nested spans, all of which overlap in depth: half of all pairs share samples
        val few = counted(pyramid(500))
        val many = counted(pyramid(2000))
        val duelsFew = few.depthEvaluations - few.shadingCalls
        val duelsMany = many.depthEvaluations - many.shadingCalls
        assertTrue(duelsMany < 6 * duelsFew, "$duelsFew evaluations for 500 spans, $duelsMany for 2000")
    }

    private fun pyramid(count: Int): Frame {
        val builder = FrameBuilder(Raster(2 * count, 2))
        for (i in 0 until count) {
            val depth = 0.5 + 0.1 * i / count
            val x0 = i.toDouble()
            val x1 = 2.0 * count - i
            builder.polygon(
                Rgba.BLACK,
                doubleArrayOf(x0, 0.0, depth, x1, 0.0, depth + 0.1, x1, 4.0, depth + 0.3, x0, 4.0, depth + 0.2),
            )
        }
        return builder.build()
    }

    @Test
    fun whatIsHiddenAndHasNoLinearDepthIsNotEvaluated() {
        val builder = FrameBuilder(Raster(64, 64))
        for (seed in 0 until 30) builder.add(Weave(seed, 64, 64, isLoose = false))
        val wall = doubleArrayOf(0.0, 0.0, 0.1, 64.0, 0.0, 0.2, 64.0, 64.0, 0.1, 0.0, 64.0, 0.0)
        val counters = counted(builder.polygon(Rgba.BLACK, wall).build())
        assertTrue(counters.fragments > 10 * 64 * 64)
        assertEquals(64L * 64, counters.depthEvaluations)
    }

    /** A sheet over the whole raster with a depth at its left and one at its right edge. */
    private fun sheet(raster: Raster, alpha: Float, left: Double, right: Double): Primitive {
        val x = raster.width.toDouble()
        val y = raster.height.toDouble()
        val contour = doubleArrayOf(0.0, 0.0, left, x, 0.0, right, x, y, right, 0.0, y, left)
        return FrameBuilder(raster).polygon(Rgba(0.2f, 0.4f, 0.6f, alpha), contour).build().primitives.single()
    }

    @Test
    fun rule_5_5_translucentSpansAreSortedOnceARow() {
        val raster = Raster(1000, 8)
        val glass = List(20) { sheet(raster, 0.25f, 0.1 + 0.03 * (it * 7 % 20), 0.12 + 0.03 * (it * 7 % 20)) }
        val counters = counted(Frame(raster, glass + sheet(raster, 1f, 0.9, 0.9)))
        assertEquals(21L * 8000, counters.shadingCalls)

        // The opaque sheet and the nearest layer at each sample; each layer and the sheet at both ends of a row
        assertEquals(2 * 8000L + 8 * (2 * 21 - 1), counters.depthEvaluations)
        assertEquals(21L * 1000, counters.peakSuspensions)
    }

    @Test
    fun rule_5_5_whereTranslucentSpansCrossTheRowIsHalved() {
        val raster = Raster(1000, 8)
        val glass = listOf(sheet(raster, 0.25f, 0.1, 0.7), sheet(raster, 0.5f, 0.6, 0.3))
        val counters = counted(Frame(raster, glass))

        // Ten halves of 1,000 samples, and as many stretches, with two depths at two ends of each
        assertTrue(counters.depthEvaluations - 8000 < 8 * 4 * 2 * 20, "$counters")
    }

    @Test
    fun rule_5_5_translucentSpansBehindAWallAreNeitherShadedNorCompared() {
        val raster = Raster(1000, 8)
        val glass = List(20) { sheet(raster, 0.25f, 0.5 + 0.02 * it, 0.51 + 0.02 * it) }
        val counters = counted(Frame(raster, glass + sheet(raster, 1f, 0.1, 0.2)))
        assertEquals(8000, counters.shadingCalls)
        assertEquals(8000L + 8 * 2 * 21, counters.depthEvaluations)
    }

    @Test
    fun numbersOfSpansAreUsedAgain() {
        val height = 10_000
        val comb = object : Primitive by Weave(0, 64, height, isLoose = true) {
            override fun spans(y: Int, spans: Spans) {
                for (i in 0 until y % 7) spans.add(4 * i, 4 * i + 2)
            }

            override fun cursor(y: Int): SpanCursor {
                var row = y
                return SpanCursor { spans ->
                    spans.clear()
                    spans(row++, spans)
                }
            }
        }
        val edges = ActiveEdges(FrameBuilder(Raster(64, height)).add(comb).build(), Counters.Builder())
        edges.moveTo(0)
        val bytes = edges.bytes
        for (y in 1 until height) edges.moveTo(y)
        assertEquals(bytes, edges.bytes)
    }

    @Test
    fun edgesAreInOrderOnEveryRow() {
        for (seed in 0L until 200L) {
            val frame = AwkwardFrames(seed).frame()
            val edges = ActiveEdges(frame, Counters.Builder())
            for (y in frame.region.rowStart until frame.region.rowEnd) {
                edges.moveTo(y)
                val expected = frame.primitives.flatMap { primitive ->
                    val spans = frame.region.spans()
                    primitive.spans(y, spans)
                    (0 until spans.count).flatMap { listOf(spans.start(it), spans.end(it)) }
                }.sorted()
                assertEquals(expected, (0 until edges.count).map { edges.column(it) })
            }
        }
    }
}
