package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.behindAll
import dev.lazyz.pipeline.PipelineScenes
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** Work and memory that strategies have in common, by their counters. */
class StrategyCostsTest {
    private fun counted(id: String, frame: Frame): Counters {
        val image = Renderers.find(id)!!.render(frame)
        assertEquals(ZBufferRenderer().render(frame), image, id)
        return image.counters
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aCityCostsFewerDepthsThanFragments() {
        val city = Stacks.city(640, 360, blocks = 16)
        val most = mapOf("scanline" to 0.25, "warnock" to 0.4, "hierarchical" to 0.5, "painter" to 0.5)
        for ((id, limit) in most) {
            val counters = counted(id, city)
            assertTrue(counters.depthEvaluations < limit * counters.fragments, "$id: $counters")
            // Painters shade all, but for a few samples of walls that snapping puts below the ground
            if (id == "painter") {
                assertTrue(counters.shadingCalls > 0.999 * counters.fragments, "$counters")
            } else {
                assertTrue(counters.fragments > 6 * counters.shadingCalls, "$id: $counters")
            }
        }
    }

    @ParameterizedTest
    @CsvSource("scanline, 12", "warnock, 20", "hierarchical, 256")
    fun whereTwoSurfacesCrossOnlyTheCrossingIsComparedBySamples(id: String, mostOfARow: Int) {
        val counters = counted(id, Stacks.crossing(256, 256))
        assertTrue(counters.depthEvaluations - 65_536 <= 256 * mostOfARow, "$id: $counters")
    }

    /** Depths of layers that overlap are compared with all tests and conventions alike. */
    @ParameterizedTest
    @CsvSource("warnock, 20, 600", "hierarchical, 5, 3276")
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun everyDepthTestRejects(id: String, steepness: Double, mostForComparing: Int) {
        for (test in DepthTest.entries) {
            for (convention in DepthConvention.entries) {
                val raster = Raster(128, 128, Rgba.WHITE, convention, test, test.behindAll)
                val counters = counted(id, Stacks.layers(raster, 100, Submission.SHUFFLED, steepness))
                assertTrue(counters.depthEvaluations < 128 * 128 + mostForComparing, "$id $test $convention $counters")
            }
        }
    }

    @Test
    fun whatIsBehindTheBackgroundIsNotEvaluated() {
        val raster = Raster(64, 64, Rgba.BLACK, DepthConvention.SMALLER_IS_NEARER, DepthTest.LESS, 0)
        val hidden = Stacks.layers(raster, 10, Submission.FRONT_TO_BACK)
        for (id in listOf("tiled", "scanline", "warnock", "hierarchical", "painter", "raycast", "bsp")) {
            assertEquals(0, counted(id, hidden).run { depthEvaluations + shadingCalls }, id)
        }
    }

    @Test
    fun anEmptyFrameIsBackground() {
        val empty = FrameBuilder(Raster(5, 4)).build()
        for (renderer in Renderers.builtIn) assertEquals(0, counted(renderer.id, empty).fragments, renderer.id)
    }

    /** More rows have more primitives; but for a sorted list, memory is the same. Tiled bins them: see its own test. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun memoryDoesNotGrowWithTheRows() {
        val all = Renderers.builtIn.filter { Capability.CONSTANT_MEMORY in it.capabilities && it.id != "tiled" }
        for (renderer in all) {
            val (few, many) = listOf(64, 4096).map { rows ->
                val stairs = renderer.render(PipelineScenes.staircase(Raster(64, rows), 16, 4)) { _, _, _, _ -> }
                val layers = Stacks.layers(Raster(16, rows), 20, Submission.SHUFFLED, steepness = 3.0)
                val sheets = renderer.render(layers) { _, _, _, _ -> }
                listOf(stairs.peakBytes - 8 * stairs.primitives, sheets.peakBytes)
            }
            assertEquals(few[1], many[1], renderer.id)
            if (renderer.id in setOf("lazy", "flow", "lists")) assertEquals(few[0], many[0], renderer.id)
        }
    }

    @Test
    fun rowsAreHandedOutBeforeLaterOnesAreBegun() {
        for (renderer in Renderers.builtIn.filter { Capability.STREAMS_ROWS in it.capabilities }) {
            val layer = PipelineScenes.layers(Raster(3, 8), 1).single()
            val rows = ArrayList<Int>()
            renderer.render(Frame(Raster(3, 8), listOf(layer))) { y, _, _, _ ->
                assertEquals(y, layer.rows.max(), renderer.id)
                rows += y
            }
            assertEquals((0 until 8).toList(), rows, renderer.id)
        }
    }
}
