package dev.lazyz.strategies.painter

import dev.lazyz.pipeline.LayeredFrames
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.scanline.AwkwardFrames
import dev.lazyz.strategies.zbuffer.ZBuffer
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

class PainterProperties {
    @Property(tries = 3000, seed = "1972")
    fun givesTheBitsOfTheDepthBuffer(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed).frame()
        val expected = ZBuffer().render(frame)
        val actual = Painter().render(frame)
        assertEquals(expected, actual, "AwkwardFrames($seed).frame()")
        assertEquals(expected.counters.fragments, actual.counters.fragments)
        assertTrue(actual.counters.shadingCalls >= expected.visible)
    }

    @Property(tries = 1500, seed = "1972")
    fun rule_5_5_blendsLikeTheLists(@ForAll seed: Long) {
        val frame = LayeredFrames.translucent(seed)
        if (!frame.hasTranslucency) return
        val expected = Lists().render(frame)
        val actual = Painter().render(frame)
        assertEquals(expected, actual, "LayeredFrames.translucent($seed)")
        assertEquals(expected.counters.fragments, actual.counters.fragments)
        assertEquals(expected.counters.shadingCalls, actual.counters.shadingCalls)
    }
}
