package dev.lazyz.conformance.probes

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.Renderers
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class SmallWorldsTest {
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun builtInRenderersAreRightInSmallWorlds() {
        for (renderer in Renderers.builtIn + ReferenceRenderer()) smallWorlds(renderer)
    }

    @Test
    fun wrongRenderersAreFoundInSmallWorlds() {
        val swap = mapOf(
            DepthTest.LESS to DepthTest.LESS_OR_EQUAL,
            DepthTest.LESS_OR_EQUAL to DepthTest.LESS,
            DepthTest.GREATER to DepthTest.GREATER_OR_EQUAL,
            DepthTest.GREATER_OR_EQUAL to DepthTest.GREATER,
        )
        for ((right, wrong) in swap) assertFound { if (it.raster.depthTest == right) it.tested(wrong) else it }
        assertFound { frame -> frame.keeping { it == 0 } }
    }

    @Test
    fun primitivesThatSetUpGotWrongAreFoundInSmallWorlds() {
        // Rules that trust primitives would accept this renderer
        assertFound { Frame(it.raster, it.primitives.map(::WithoutLeftColumn)) }
    }

    private fun assertFound(change: (Frame) -> Frame) {
        val wrong = object : Renderer by ReferenceRenderer() {
            override fun render(frame: Frame, sink: RowSink): Counters = ReferenceRenderer().render(change(frame), sink)

            override fun render(frame: Frame): Image = ReferenceRenderer().render(change(frame))
        }
        val error = assertThrows(AssertionError::class.java) { smallWorlds(wrong) }
        assertTrue("FrameBuilder(Raster(3, 2" in error.message.orEmpty()) { "${error.message}" }
    }

    private fun Frame.tested(test: DepthTest): Frame = Frame(raster.withDepthTest(test), primitives)

    private class WithoutLeftColumn(private val whole: Primitive) : Primitive by whole {
        override fun spans(y: Int, spans: Spans) {
            val all = Spans().also { whole.spans(y, it) }
            for (i in 0 until all.count) if (all.end(i) > 1) spans.add(maxOf(all.start(i), 1), all.end(i))
        }
    }

    @Test
    fun smallWorldsAreFullOfTiesAndCrossings() {
        val world = SmallWorld(Raster(3, 2))
        val (ties, crossings) = world.ties()
        assertTrue(world.pictures >= 1600) { "${world.pictures} pictures" }
        assertTrue(ties > world.pictures / 5) { "$ties of ${world.pictures} have ties" }
        assertTrue(crossings > world.pictures / 20) { "$crossings of ${world.pictures} have crossings" }
    }
}
