package dev.lazyz

import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** What the three ways of late shading cost, in starts and steps, by every renderer that offers them. */
class CoherentShadingTest {
    private val raster = Raster(512, 8)

    /** One wall, visible everywhere. */
    private val wall = frame(pickets = 0, pitch = 1) { it }

    /** The wall behind pickets that let it through at every 32nd column only; steps have nothing to do with pickets. */
    private val fence = frame(pickets = 16, pitch = 32) { Plain(it) }

    @TestFactory
    fun incrementalWinsOnAWall(): List<DynamicTest> = forEachRenderer { renderer ->
        val direct = counters(renderer, wall, Coherence.DIRECT)
        val incremental = counters(renderer, wall, Coherence.INCREMENTAL)
        assertEquals(512L * 8, direct.shadingStarts)
        assertEquals(0, direct.shadingSteps)
        assertEquals(8, incremental.shadingStarts)
        assertEquals(511L * 8, incremental.shadingSteps)
        assertEquals(1, incremental.longestChain)
        assertTrue(cost(incremental) < 0.3 * cost(direct))
        assertNearTheBetter(renderer, wall)
    }

    @TestFactory
    fun directWinsBehindAFence(): List<DynamicTest> = forEachRenderer { renderer ->
        val direct = counters(renderer, fence, Coherence.DIRECT)
        val incremental = counters(renderer, fence, Coherence.INCREMENTAL)
        assertEquals(512L * 8, direct.shadingStarts)
        assertEquals(8 + PICKETS, incremental.shadingStarts)
        assertEquals(15L * 8 * 32, incremental.shadingSteps)
        assertEquals(32, incremental.longestChain)

        // Of the wall itself, seen through the gaps
        val pickets = PICKETS * Primitive.DEFAULT_SHADING_START_COST
        assertTrue(cost(direct) - pickets < 0.3 * (cost(incremental) - pickets))
        assertNearTheBetter(renderer, fence)
    }

    @TestFactory
    fun adaptiveIsNearTheBetterOnAnything(): List<DynamicTest> = forEachRenderer { renderer ->
        for (seed in 1L..20L) assertNearTheBetter(renderer, SampleScenes.mixed(Random(seed)).frame(60, 40))
    }

    @TestFactory
    fun memoryIsWhatTheChainsOfARowTake(): List<DynamicTest> = forEachRenderer { renderer ->
        val crowd = frame(pickets = 256, pitch = 2) { it }
        val direct = counters(renderer, crowd, Coherence.DIRECT).peakBytes
        val incremental = counters(renderer, crowd, Coherence.INCREMENTAL).peakBytes
        val chains = 257 * 152L
        assertTrue(incremental - direct in 1..chains + 512) { "$incremental, $direct" }
    }

    @TestFactory
    fun adaptiveHeedsWhatAPrimitiveSaysOfItsStarts(): List<DynamicTest> = forEachRenderer { renderer ->
        for (cost in listOf(0, 31, 32)) {
            val dear = Frame(raster, fence.primitives.map { Dear(it, cost) })
            val starts = counters(renderer, dear, Coherence.ADAPTIVE).shadingStarts
            val ofWall = if (cost < 32) 16L * 8 else 8
            assertEquals(ofWall + PICKETS, starts) { "$cost" }
        }
    }

    @Test
    fun severalRenderersShadeLate() {
        assertTrue(lateRenderers().size >= 5) { "${lateRenderers()}" }
    }

    private fun assertNearTheBetter(renderer: Renderer, frame: Frame) {
        val better = minOf(
            cost(counters(renderer, frame, Coherence.DIRECT)), cost(counters(renderer, frame, Coherence.INCREMENTAL)),
        )
        val adaptive = cost(counters(renderer, frame, Coherence.ADAPTIVE))
        assertTrue(adaptive <= better) { "adaptive $adaptive, the better of both $better" }
    }

    /** What the attributes cost, in steps. */
    private fun cost(counters: Counters): Long =
        counters.shadingStarts * Primitive.DEFAULT_SHADING_START_COST + counters.shadingSteps

    /** In tiles as wide as the raster, if there are tiles: chains end with a tile's row. */
    private fun counters(renderer: Renderer, frame: Frame, coherence: Coherence): Counters =
        renderer.configured(RenderOptions(coherence, threads = 1, tileSize = 512)).render(frame).counters

    private fun lateRenderers(): List<Renderer> = Renderers.builtIn.filter { Capability.COHERENCE in it.capabilities }

    private fun forEachRenderer(test: (Renderer) -> Unit): List<DynamicTest> =
        lateRenderers().map { renderer -> dynamicTest(renderer.id) { test(renderer) } }

    /** A wall behind [pickets], each of which leaves one column free of [pitch]. */
    private fun frame(pickets: Int, pitch: Int, picket: (Primitive) -> Primitive): Frame {
        val builder = FrameBuilder(raster)
        val shader = Shader { it.setColor(it.worldX, it.worldY, it.worldZ) }
        fun box(from: Int, until: Int, depth: Double) = doubleArrayOf(
            from.toDouble(), 0.0, depth, until.toDouble(), 0.0, depth, until.toDouble(), 8.0, depth,
            from.toDouble(), 8.0, depth,
        )
        builder.polygon(shader, FillRule.NON_ZERO, box(0, raster.width, 0.75))
        for (i in 0 until pickets) builder.polygon(shader, FillRule.NON_ZERO, box(i * pitch + 1, (i + 1) * pitch, 0.25))
        val primitives = builder.build().primitives
        return Frame(raster, primitives.take(1) + primitives.drop(1).map(picket))
    }

    /** A primitive whose colours cannot be stepped. */
    private class Plain(whole: Primitive) : Primitive by whole {
        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
    }

    /** A primitive that says what its starts cost. */
    private class Dear(whole: Primitive, override val shadingStartCost: Int) : Primitive by whole

    private companion object {
        /** Samples of the fence at which a picket is visible. */
        const val PICKETS = 16L * 31 * 8
    }
}
