package dev.lazyz.strategies.hierarchical

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.Stacks
import dev.lazyz.strategies.Submission
import dev.lazyz.strategies.counted
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer.Order
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class HierarchicalRendererTest {
    private fun counted(frame: Frame) = HierarchicalRenderer().counted(frame)

    private fun rectangle(left: Int, top: Int, right: Int, bottom: Int, near: Double, far: Double): DoubleArray {
        val (x0, x1) = listOf(left.toDouble(), right.toDouble())
        val (y0, y1) = listOf(top.toDouble(), bottom.toDouble())
        return doubleArrayOf(x0, y0, near, x1, y0, near, x1, y1, far, x0, y1, far)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun hundredsOfLayersCostAsManyDepthsAsOne() {
        for (submission in Submission.entries) {
            for (count in listOf(1, 10, 200)) {
                val counters = counted(Stacks.layers(Raster(128, 128), count, submission))
                assertEquals(count * 16_384L, counters.fragments)
                assertEquals(16_384, counters.depthEvaluations, "$count layers $submission")
            }
        }
    }

    /** Draws in the order of submission, and checks that picture and shading calls do not depend on it. */
    private fun unsorted(frame: Frame): Counters {
        val image = HierarchicalRenderer(order = Order.SUBMISSION).render(frame)
        assertEquals(HierarchicalRenderer().render(frame), image)
        assertEquals(image.visible.toLong(), image.counters.shadingCalls)
        return image.counters
    }

    @Test
    fun withoutSortingTheCostDependsOnTheOrderOfSubmission() {
        val best = unsorted(Stacks.layers(Raster(64, 64), 1000, Submission.FRONT_TO_BACK))
        assertEquals(listOf(4_096L, 4_096L), listOf(best.depthEvaluations, best.depthPasses))

        // From back to front, each layer is the nearest when it is drawn: nothing is rejected
        val worst = unsorted(Stacks.layers(Raster(64, 64), 1000, Submission.BACK_TO_FRONT))
        assertEquals(listOf(4_096_000L, 4_096_000L), listOf(worst.depthEvaluations, worst.depthPasses))
        assertEquals(best.shadingCalls, worst.shadingCalls)
        assertEquals(listOf(4_096_000L, 4_096_000L), listOf(best.fragments, worst.fragments))
    }

    @Test
    fun theOrderIsKeptWhenOptionsChange() {
        val frame = Stacks.layers(Raster(32, 32), 10, Submission.BACK_TO_FRONT)
        val configured = HierarchicalRenderer(order = Order.SUBMISSION).configured(RenderOptions(threads = 1))
        assertEquals(10L * 1024, configured.render(frame).counters.depthEvaluations)
        val sorted = HierarchicalRenderer().render(frame).counters.peakBytes
        assertEquals(sorted - 8 * 10, configured.render(frame).counters.peakBytes)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun layersThatOverlapInDepthCostLittleMore() {
        // Ten of them reach before the farthest sample of the first: they are tested block by block
        for (submission in Submission.entries) {
            val counters = counted(Stacks.layers(Raster(128, 128), 300, submission, steepness = 10.0))
            assertTrue(counters.depthEvaluations <= 16_384 * 1.2, "$submission $counters")
        }
    }

    @Test
    fun aHiddenPrimitiveIsNotEvaluated() {
        // The primitive has no linear form, so its depth cannot be known without evaluating it
        val frame = FrameBuilder(Raster(300, 200))
            .add(NeverEvaluated(300, 200))
            .polygon(Rgba.BLACK, rectangle(0, 0, 300, 200, 0.2, 0.4))
            .build()
        val counters = counted(Frame(frame.raster, frame.primitives.drop(1)))
        assertEquals(300 * 200, counters.depthEvaluations)
        val image = HierarchicalRenderer().render(frame)
        assertEquals(300 * 200, image.counters.depthEvaluations)
        assertEquals(2L * 300 * 200, image.counters.fragments)
    }

    @Test
    fun aHiddenPrimitiveIsRejectedByFourCellsAtMost() {
        val random = Random(1993)
        val builder = FrameBuilder(Raster(500, 300)).polygon(Rgba.BLACK, rectangle(0, 0, 500, 300, 0.1, 0.2))
        repeat(1000) {
            val left = random.nextInt(500)
            val top = random.nextInt(300)
            val right = random.nextInt(left, 500) + 1
            builder.polygon(Rgba.BLACK, rectangle(left, top, right, random.nextInt(top, 300) + 1, 0.3, 0.9))
        }
        val frame = builder.build()
        val counters = Counters.Builder()
        val drawing = PyramidDrawing(frame, counters)
        drawing.draw(0)
        val looks = drawing.pyramid.looks
        for (index in 1..1000) drawing.draw(index)
        assertTrue(drawing.pyramid.looks - looks <= 4000, "${drawing.pyramid.looks - looks}")
        assertEquals(500L * 300, counters.depthEvaluations)
    }

    @Test
    fun blocksAreRejectedWhereThePrimitiveIsNot() {
        // A wall before the left three quarters; the depths of the slope overlap those of the wall
        val counters = counted(
            FrameBuilder(Raster(256, 256))
                .polygon(Rgba.BLACK, rectangle(0, 0, 192, 256, 0.1, 0.5))
                .polygon(Rgba.BLACK, rectangle(0, 0, 256, 256, 0.3, 0.7))
                .build(),
        )
        assertEquals(192L * 256 + 256 * 256, counters.fragments)
        val asking = counters.depthEvaluations - 256 * 256
        assertTrue(asking <= 32 * 32, "$asking depths to ask for blocks")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun memoryIsTheImageAndThePyramid() {
        val counters = counted(Stacks.layers(Raster(512, 512), 100, Submission.SHUFFLED))
        val blocks = 64L * 64
        val image = 8L * 512 * 512
        assertTrue(counters.peakBytes > image + blocks * 8 * 4 / 3, "${counters.peakBytes}")
        assertTrue(counters.peakBytes < image + blocks * 12 + 8 * 100 + 20 * 512, "${counters.peakBytes}")
    }

    @Test
    fun cellsHoldTheFarthestKeyOfTheirSamples() {
        for (seed in 0L until 300L) {
            val frame = AwkwardFrames(seed).frame()
            val test = frame.raster.depthTest
            val drawing = PyramidDrawing(frame, Counters.Builder())
            for (index in frame.primitives.indices) {
                drawing.draw(index)
                drawing.pyramid.assertCurrent()
            }
            val picture = ZBufferRenderer().render(frame)
            assertEquals(
                List(picture.depth.size) { test.key(picture.depth[it], picture.primitive[it]) },
                drawing.keys.toList(),
            )
        }
    }

    /** Checks that at every level a key is hidden in exactly those blocks in which all samples have lesser keys. */
    private fun DepthPyramid.assertCurrent() {
        for (level in 0 until levelCount) {
            val size = DepthPyramid.BLOCK shl level
            for (row in 0..(region.height - 1) / size) {
                for (column in 0..(region.width - 1) / size) {
                    var farthest = 0L
                    for (y in row * size until minOf((row + 1) * size, region.height)) {
                        for (x in column * size until minOf((column + 1) * size, region.width)) {
                            farthest = maxOf(farthest, keys[y * region.width + x])
                        }
                    }
                    assertTrue(isHidden(farthest + 1, level, column, row), "$level $column $row")
                    assertTrue(!isHidden(farthest, level, column, row), "$level $column $row")
                }
            }
        }
    }
}

/** As wide as the raster, and behind half of the depth range. */
private class NeverEvaluated(private val width: Int, override val rowEnd: Int) : Primitive {
    override val rowStart: Int get() = 0
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = width
    override val leastDepth: Int get() = Int.MAX_VALUE / 2

    override fun spans(y: Int, spans: Spans) {
        if (y in 0 until rowEnd) spans.add(0, width)
    }

    override fun depth(x: Int, y: Int): Int = throw AssertionError("depth at ($x, $y)")

    override fun shade(fragment: Fragment): Unit = throw AssertionError("colour at (${fragment.x}, ${fragment.y})")
}
