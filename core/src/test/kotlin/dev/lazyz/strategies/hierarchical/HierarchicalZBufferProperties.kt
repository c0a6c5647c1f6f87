package dev.lazyz.strategies.hierarchical

import dev.lazyz.Coherence
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.strategies.hierarchical.HierarchicalZBuffer.Order
import dev.lazyz.strategies.scanline.AwkwardFrames
import dev.lazyz.strategies.warnock.AreaFrames
import dev.lazyz.strategies.zbuffer.ZBuffer
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals

class HierarchicalZBufferProperties {
    private fun assertSame(frame: Frame, name: String) {
        val expected = ZBuffer().render(frame)
        val actual = HierarchicalZBuffer().render(frame)
        assertEquals(expected, actual, name)
        assertEquals(expected.counters.fragments, actual.counters.fragments, name)
        assertEquals(expected.visible.toLong(), actual.counters.shadingCalls, name)
        assertEquals(expected, HierarchicalZBuffer(order = Order.SUBMISSION).render(frame), name)
    }

    @Property(tries = 3000, seed = "1993")
    fun givesTheBitsOfTheDepthBuffer(@ForAll seed: Long) {
        assertSame(AreaFrames(seed).frame(), "AreaFrames($seed).frame()")
    }

    @Property(tries = 1000, seed = "1993")
    fun givesTheBitsOfTheDepthBufferForOtherFrames(@ForAll seed: Long) {
        assertSame(AwkwardFrames(seed).frame(), "AwkwardFrames($seed).frame()")
    }

    @Property(tries = 300, seed = "1993")
    fun givesTheSameBitsUnderEveryCoherence(@ForAll seed: Long) {
        val frame = AreaFrames(seed).frame()
        val expected = ZBuffer().render(frame)
        for (coherence in Coherence.entries) {
            val renderer = HierarchicalZBuffer().configured(RenderOptions(coherence))
            assertEquals(expected, renderer.render(frame), "AreaFrames($seed).frame(), $coherence")
        }
    }
}
