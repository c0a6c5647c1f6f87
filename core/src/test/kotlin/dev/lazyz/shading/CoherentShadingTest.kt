package dev.lazyz.shading

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.SampleScenes
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.strategies.Renderers
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The cost of the three modes of late shading, in starts and steps, for every renderer that supports them. */
class CoherentShadingTest {
    private val raster = Raster(512, 8)

    /** A single wall, visible everywhere, whose starts are expensive. */
    private val wall = frame(wallCost = 64, pickets = 0, pitch = 1) { it }

    /** The wall behind pickets that leave only every 32nd column visible; the pickets do not support stepping. */
    private val fence = frame(wallCost = 4, pickets = 16, pitch = 32) { Plain(it) }

    @TestFactory
    fun incrementalWinsOnAWall(): List<DynamicTest> = forEachRenderer { renderer ->
        val direct = counters(renderer, wall, Coherence.DIRECT)
        val incremental = counters(renderer, wall, Coherence.INCREMENTAL)
        assertEquals(512L * 8, direct.shadingStarts)
        assertEquals(0, direct.shadingSteps)
        assertEquals(8, incremental.shadingStarts)
        assertEquals(511L * 8, incremental.shadingSteps)
        assertEquals(1, incremental.longestChain)
        assertTrue(64 * incremental.shadingStarts + incremental.shadingSteps < 0.02 * 64 * direct.shadingStarts)

        // The adaptive mode is as good as the better of the other two
        val adaptive = counters(renderer, wall, Coherence.ADAPTIVE)
        assertEquals(incremental.shadingStarts, adaptive.shadingStarts)
        assertEquals(incremental.shadingSteps, adaptive.shadingSteps)
    }

    @TestFactory
    fun directWinsBehindAFence(): List<DynamicTest> = forEachRenderer { renderer ->
        val direct = counters(renderer, fence, Coherence.DIRECT)
        val incremental = counters(renderer, fence, Coherence.INCREMENTAL)
        assertEquals(512L * 8, direct.shadingStarts)
        assertEquals(8 + PICKETS, incremental.shadingStarts)
        assertEquals(15L * 8 * 32, incremental.shadingSteps)
        assertEquals(32, incremental.longestChain)

        // Of the wall only, seen through the gaps
        val gaps = direct.shadingStarts - PICKETS
        assertTrue(4 * gaps < 0.2 * (4 * 8 + incremental.shadingSteps))

        // The adaptive mode is as good as the better of the other two
        val adaptive = counters(renderer, fence, Coherence.ADAPTIVE)
        assertEquals(direct.shadingStarts, adaptive.shadingStarts)
        assertEquals(0, adaptive.shadingSteps)
    }

    @TestFactory
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun adaptiveIsNeverMoreExpensiveThanTheBetter(): List<DynamicTest> = forEachRenderer { renderer ->
        for (seed in 1L..20L) {
            val mixed = SampleScenes.mixed(Random(seed)).frame(60, 40)
            val cost = seed.toInt()
            val frame = Frame(mixed.raster, mixed.primitives.map { Expensive(it, cost) })
            val costs = Coherence.entries.associateWith { coherence ->
                counters(renderer, frame, coherence).let { it.shadingStarts * cost + it.shadingSteps }
            }
            val better = minOf(costs.getValue(Coherence.DIRECT), costs.getValue(Coherence.INCREMENTAL))
            assertTrue(costs.getValue(Coherence.ADAPTIVE) <= better) { "$seed: $costs" }
        }
    }

    @TestFactory
    fun memoryIsWhatTheChainsOfARowTake(): List<DynamicTest> = forEachRenderer { renderer ->
        val crowd = frame(wallCost = 0, pickets = 256, pitch = 2) { it }
        val direct = counters(renderer, crowd, Coherence.DIRECT).peakBytes
        val incremental = counters(renderer, crowd, Coherence.INCREMENTAL).peakBytes
        val chains = 257 * 152L
        assertTrue(incremental in chains..direct + chains + 512) { "$incremental, $direct" }

        // Instead of chains, tiles store which samples show each primitive
        if (renderer.id != "tiled") assertTrue(incremental > direct) { "$incremental, $direct" }
    }

    @TestFactory
    fun adaptiveUsesTheStartCostOfAPrimitive(): List<DynamicTest> = forEachRenderer { renderer ->
        for (cost in listOf(0, 31, 32)) {
            val expensive = Frame(raster, fence.primitives.map { Expensive(it, cost) })
            val starts = counters(renderer, expensive, Coherence.ADAPTIVE).shadingStarts
            val ofWall = if (cost < 32) 16L * 8 else 8
            assertEquals(ofWall + PICKETS, starts) { "$cost" }
        }
    }

    /** Uses tiles as wide as the raster, for renderers that have tiles, because chains end with a row of a tile. */
    private fun counters(renderer: Renderer, frame: Frame, coherence: Coherence): Counters =
        renderer.configured(RenderOptions(coherence, threads = 1, tileSize = 512)).render(frame).counters

    private fun lateRenderers(): List<Renderer> = Renderers.builtIn.filter { Capability.COHERENCE in it.capabilities }

    private fun forEachRenderer(test: (Renderer) -> Unit): List<DynamicTest> =
        lateRenderers().map { renderer -> dynamicTest(renderer.id) { test(renderer) } }

    /** A wall behind [pickets], which leave one of every [pitch] columns free. */
    private fun frame(wallCost: Int, pickets: Int, pitch: Int, picket: (Primitive) -> Primitive): Frame {
        val builder = FrameBuilder(raster)
        val shader = Shader { it.setColor(it.worldX, it.worldY, it.worldZ) }
        fun box(from: Int, until: Int, depth: Double) = doubleArrayOf(
            from.toDouble(), 0.0, depth, until.toDouble(), 0.0, depth, until.toDouble(), 8.0, depth,
            from.toDouble(), 8.0, depth,
        )
        builder.polygon(shader, FillRule.NON_ZERO, box(0, raster.width, 0.75))
        for (i in 0 until pickets) builder.polygon(shader, FillRule.NON_ZERO, box(i * pitch + 1, (i + 1) * pitch, 0.25))
        val primitives = builder.build().primitives
        return Frame(raster, listOf(Expensive(primitives[0], wallCost)) + primitives.drop(1).map(picket))
    }

    /** A primitive that does not support stepping. */
    private class Plain(whole: Primitive) : Primitive by whole {
        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
    }

    /** A primitive with a given cost of a start. */
    private class Expensive(whole: Primitive, override val shadingStartCost: Int) : Primitive by whole

    private companion object {
        /** Samples of the fence at which a picket is visible. */
        const val PICKETS = 16L * 31 * 8
    }
}
