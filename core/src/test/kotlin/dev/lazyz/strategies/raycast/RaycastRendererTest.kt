package dev.lazyz.strategies.raycast

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.behindAll
import dev.lazyz.raster.BoxTree
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.Stacks
import dev.lazyz.strategies.Submission
import dev.lazyz.strategies.counted
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RaycastRendererTest {
    private fun counted(frame: Frame) = RaycastRenderer().counted(frame)

    @Test
    fun layersApartInDepthCostOneDepthASample() {
        for (test in DepthTest.entries) {
            for (convention in DepthConvention.entries) {
                val raster = Raster(40, 30, Rgba.WHITE, convention, test, test.behindAll)
                for (submission in Submission.entries) {
                    val counters = counted(Stacks.layers(raster, 100, submission))
                    val work = counters.run { listOf(fragments, depthEvaluations, depthPasses) }
                    assertEquals(listOf(1200L, 1200L, 1200L), work)
                }
            }
        }
    }

    @Test
    fun layersThatOverlapInDepthCostThoseThatMayBeNearer() {
        // A sheet may be nearer than the visible one only if their extents of depth overlap
        val counters = counted(Stacks.layers(Raster(64, 64), 200, Submission.SHUFFLED, steepness = 10.0))
        assertTrue(counters.depthEvaluations < 11 * 64 * 64, "$counters")
        assertTrue(counters.depthPasses in 64 * 64 until counters.depthEvaluations, "$counters")
    }

    @Test
    fun rule_5_5_onlyWhatShinesThroughIsShaded() {
        val builder = FrameBuilder(Raster(16, 16))
        for (i in 0 until 60) {
            val z = 0.9 - 0.8 * (i * 7 % 60) / 60
            val alpha = if (i * 7 % 60 % 20 == 0) 1f else 0.125f
            val sheet = doubleArrayOf(0.0, 0.0, z, 16.0, 0.0, z, 16.0, 16.0, z, 0.0, 16.0, z)
            builder.polygon(Rgba(0.2f, 0.4f, 0.6f, alpha), sheet)
        }
        val frame = builder.build()
        val expected = ListsRenderer().render(frame)
        val image = RaycastRenderer().render(frame)
        assertEquals(expected, image)
        assertEquals(20L * 256, image.counters.shadingCalls)
        assertTrue(image.counters.fragments < 60L * 256, "${image.counters}")
        assertTrue(image.counters.peakSuspensions in 20 until 60, "${image.counters}")
    }

    /** [count] small triangles all over the picture; together they cover each sample about four times. */
    private fun confetti(count: Int, side: Int): Frame {
        val random = Random(47)
        val size = StrictMath.sqrt(8.0 * 4 / count)
        val positions = FloatArray(9 * count)
        for (i in 0 until count) {
            val x = 2 * random.nextDouble() - 1
            val y = 2 * random.nextDouble() - 1
            val z = 2 * random.nextDouble() - 1
            for (k in 0 until 3) {
                positions[9 * i + 3 * k] = (x + if (k == 1) size else 0.0).toFloat()
                positions[9 * i + 3 * k + 1] = (y + if (k == 2) size else 0.0).toFloat()
                positions[9 * i + 3 * k + 2] = z.toFloat()
            }
        }
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 0.0, 8.0)
        val mesh = Mesh(positions, IntArray(3 * count) { it }, Material())
        return Scene(listOf(mesh), viewpoint = camera).frame(side, side)
    }

    /** The figures of docs/algorithms/raycast.md. */
    @Test
    fun theWorkForASampleGrowsWithTheLogarithmOfThePrimitives() {
        val looks = listOf(1_000, 10_000, 100_000).map { count ->
            val frame = confetti(count, 256)
            val counters = Counters.Builder()
            val ray = Ray(frame, BoxTree(frame), counters)
            for (y in 0 until 256 step 8) {
                ray.beginRow(y)
                for (x in 0 until 256 step 8) ray.cast(x)
            }
            assertTrue(counters.fragments < 3 * 1024) { "$count: $counters" }
            ray.looks / 1024.0
        }
        assertTrue(looks[2] < 160 && looks[2] < 2.5 * looks[0]) { "nodes a sample: $looks" }
    }

    @Test
    fun aSampleOfALargeMeshMakesFewObjects() {
        val frame = confetti(20_000, 916)
        val whole = RaycastRenderer().render(frame) { _, _, _, _ -> }
        assertTrue(whole.peakBytes < 75L * 20_000, "$whole")
        val one = RaycastRenderer().render(frame.within(Region(450, 450, 451, 451)))
        assertEquals(frame.at(450, 450)?.primitive, one.primitive(450, 450))
        assertTrue(one.counters.fragments <= 4 && one.counters.peakBytes < 20_000, "${one.counters}")
    }

    @Test
    fun theSpansOfARowAreAskedForOnceAndOnlyWhereASampleMeetsTheBox() {
        val raster = Raster(200, 200)
        val asked = IntArray(200)
        val layer = Stacks.layers(raster, 1, Submission.FRONT_TO_BACK).primitives[0]
        val witness = object : Primitive by layer {
            override fun cursor(y: Int): SpanCursor = throw AssertionError("row $y")

            override fun spans(y: Int, spans: Spans) {
                asked[y]++
                layer.spans(y, spans)
            }
        }
        RaycastRenderer().render(Frame(raster, listOf(witness), Region(7, 3, 9, 190)))
        assertEquals(List(200) { if (it in 3 until 190) 1 else 0 }, asked.toList())
    }

    /** The tree has exactly the primitives that reach the region, and each box contains those below. */
    @Test
    fun boxesContainWhatIsBelow() {
        for (seed in 0L until 200L) {
            val frame = AwkwardFrames(seed).frame()
            val tree = BoxTree(frame)
            val found = (tree.size until 2 * tree.size).map { tree.primitive(it) }
            val region = frame.region
            val expected = frame.primitives.indices.filter { i ->
                val p = frame.primitives[i]
                region.intersect(p.columnStart, p.rowStart, p.columnEnd, p.rowEnd) != null
            }
            assertEquals(expected, found.sorted(), "$seed")
            for (leaf in tree.size until 2 * tree.size) {
                val p = frame.primitives[tree.primitive(leaf)]
                val box = checkNotNull(region.intersect(p.columnStart, p.rowStart, p.columnEnd, p.rowEnd))
                var node = leaf
                while (node >= BoxTree.ROOT) {
                    assertTrue(tree.contains(node, box.columnStart, box.rowStart), "$seed")
                    assertTrue(tree.contains(node, box.columnEnd - 1, box.rowEnd - 1), "$seed")
                    node /= 2
                }
                assertEquals(false, tree.contains(leaf, box.columnStart - 1, box.rowStart))
                assertEquals(false, tree.contains(leaf, box.columnEnd, box.rowEnd - 1))
                assertEquals(false, tree.contains(leaf, box.columnStart, box.rowEnd))
                assertEquals(false, tree.contains(leaf, box.columnStart, box.rowStart - 1))
            }
        }
    }
}
