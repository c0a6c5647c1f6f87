package dev.lazyz.strategies.painter

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
}
