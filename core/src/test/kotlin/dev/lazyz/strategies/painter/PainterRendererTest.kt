package dev.lazyz.strategies.painter

import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.behindAll
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.Stacks
import dev.lazyz.strategies.Submission
import dev.lazyz.strategies.counted
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class PainterRendererTest {
    private fun counted(frame: Frame) = PainterRenderer().counted(frame)

    @Test
    fun overdrawIsTotalWhereThereIsAnOrder() {
        for (test in DepthTest.entries) {
            val raster = Raster(64, 64, Rgba.WHITE, DepthConvention.SMALLER_IS_NEARER, test, test.behindAll)
            for (steepness in listOf(0.5, 20.0)) {
                val counters = counted(Stacks.layers(raster, 50, Submission.BACK_TO_FRONT, steepness))
                assertEquals(50L * 64 * 64, counters.fragments)
                assertEquals(counters.fragments, counters.shadingCalls)
            }
        }
    }

    @Test
    fun extentsOfDepthProveAnOrderWithoutEvaluatingDepths() {
        // Depth is evaluated once a sample, for the output
        val counters = counted(Stacks.layers(Raster(64, 64), 50, Submission.BACK_TO_FRONT))
        assertEquals(64L * 64, counters.depthEvaluations)
    }

    @Test
    fun planesMendTheOrderOfGreatestDepth() {
        // The slope extends farther back than the post, but the post is behind it
        val slope = doubleArrayOf(0.0, 0.0, 0.9, 64.0, 0.0, 0.1, 64.0, 64.0, 0.1, 0.0, 64.0, 0.9)
        val post = doubleArrayOf(40.0, 10.0, 0.6, 60.0, 10.0, 0.6, 60.0, 50.0, 0.6, 40.0, 50.0, 0.6)
        for (contours in listOf(listOf(slope, post), listOf(post, slope))) {
            val builder = FrameBuilder(Raster(64, 64))
            for (contour in contours) builder.polygon(Rgba.BLACK, contour)
            val counters = counted(builder.build())
            assertEquals(64L * 64 + 20 * 40, counters.fragments)
            assertEquals(counters.fragments, counters.shadingCalls)
        }
    }

    @Test
    fun aCircleIsResolvedWithoutAnOrder() {
        // Four bars, each over the next at one end and under the one before at the other, so that they form a cycle
        val counters = counted(circle(1f))
        assertEquals(4L * 80 * 10, counters.fragments)
        assertEquals(counters.fragments - 10 * 10, counters.shadingCalls)
        assertTrue(counters.depthEvaluations < counters.fragments, "$counters")
    }

    private fun circle(alpha: Float): Frame {
        val color = Rgba(0.2f, 0.4f, 0.6f, alpha)
        val builder = FrameBuilder(Raster(100, 100))
        val near = 0.2
        val far = 0.8
        builder.polygon(color, bar(10.0, 20.0, 90.0, 30.0, near, far, far, near))
        builder.polygon(color, bar(70.0, 10.0, 80.0, 90.0, near, near, far, far))
        builder.polygon(color, bar(10.0, 70.0, 90.0, 80.0, far, near, near, far))
        builder.polygon(color, bar(20.0, 10.0, 30.0, 90.0, far, far, near, near))
        return builder.build()
    }

    /** A rectangle with depths at its corners, clockwise from the upper left. */
    private fun bar(x0: Double, y0: Double, x1: Double, y1: Double, vararg z: Double) =
        doubleArrayOf(x0, y0, z[0], x1, y0, z[1], x1, y1, z[2], x0, y1, z[3])

    /** A frame of sheets over the whole raster, each nearer than the one before, with these alphas. */
    private fun sheets(raster: Raster, vararg alphas: Float): Frame {
        val x = raster.width.toDouble()
        val y = raster.height.toDouble()
        val builder = FrameBuilder(raster)
        for ((i, alpha) in alphas.withIndex()) {
            val z = 0.9 - 0.8 * i / alphas.size
            builder.polygon(Rgba(0.2f, 0.4f, 0.6f, alpha), bar(0.0, 0.0, x, y, z, z, z, z))
        }
        return builder.build()
    }

    @Test
    fun rule_5_5_layersArePaintedOverEachOtherWithoutComparingDepths() {
        val counters = counted(sheets(Raster(32, 32), 1f, *FloatArray(40) { 0.125f }))
        assertEquals(41L * 1024, counters.fragments)
        assertEquals(counters.fragments, counters.shadingCalls)
        assertEquals(counters.fragments, counters.peakSuspensions)

        // Depth is evaluated once a sample, for the output
        assertEquals(1024, counters.depthEvaluations)
    }

    @Test
    fun rule_5_5_anOpaqueSheetRemovesTheLayersThatItIsOver() {
        val alphas = FloatArray(300) { if (it % 3 == 0) 1f else 0.5f }
        val counters = counted(sheets(Raster(32, 32), *alphas))
        assertEquals(300L * 1024, counters.depthPasses)
        assertEquals(3L * 1024, counters.shadingCalls)
        assertEquals(3L * 1024, counters.peakSuspensions)

        // 8 bytes a sample, two layers of 8 bytes; all else is for the primitives
        val few = counted(sheets(Raster(32, 32), 1f, 0.5f, 0.5f)).peakBytes
        assertTrue(counters.peakBytes - few < 300 * 400, "$few bytes for 3 sheets, ${counters.peakBytes} for 300")
    }

    @Test
    fun rule_5_5_glassInACircleIsBlendedInTheOrderOfEachSample() {
        val counters = counted(circle(0.5f))
        assertEquals(4L * 80 * 10, counters.fragments)
        assertEquals(counters.fragments, counters.shadingCalls)
        assertTrue(counters.depthEvaluations < counters.fragments, "$counters")
    }

    @Test
    fun smallPrimitivesAreFoundInAboutNLogN() {
        val looks = listOf(2_000, 16_000).map { count ->
            val frame = confetti(count)
            val order = PaintOrder(frame, PairOrder(frame, Counters.Builder()))
            var painted = 0
            order.forEach { painted++ }
            assertTrue(painted <= count)
            order.looks.toDouble() / count
        }
        assertTrue(looks[1] < 2 * looks[0], "looks a primitive: $looks")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun looksAreBoundedWhereAllOverlapAll() {
        val random = Random(3)
        val builder = FrameBuilder(Raster(8, 8))
        repeat(1_000) {
            val z = DoubleArray(3) { random.nextDouble() }
            builder.polygon(Rgba.BLACK, doubleArrayOf(0.0, 0.0, z[0], 16.0, 0.0, z[1], 0.0, 16.0, z[2]))
        }
        val frame = builder.build()
        counted(frame)
        val order = PaintOrder(frame, PairOrder(frame, Counters.Builder()))
        order.forEach { }
        assertTrue(order.looks < (PaintOrder.LOOKS_PER_PRIMITIVE + 3) * 1_000, "${order.looks}")
    }

    /**
     * Small triangles all over a raster whose size grows with their number, so that each overlaps about five others.
     */
    private fun confetti(count: Int): Frame {
        val random = Random(7)
        val side = 8 * StrictMath.sqrt(count.toDouble()).toInt()
        val builder = FrameBuilder(Raster(side, side))
        repeat(count) {
            val x = random.nextDouble() * side
            val y = random.nextDouble() * side
            val contour = DoubleArray(9) { i ->
                when (i % 3) {
                    0 -> x + random.nextDouble() * 12
                    1 -> y + random.nextDouble() * 12
                    else -> random.nextDouble()
                }
            }
            builder.polygon(Rgba.BLACK, contour)
        }
        return builder.build()
    }
}
