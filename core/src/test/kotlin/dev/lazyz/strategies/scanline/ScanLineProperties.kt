package dev.lazyz.strategies.scanline

import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.pipeline.LayeredFrames
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.zbuffer.ZBuffer
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals

class ScanLineProperties {
    @Property(tries = 3000, seed = "1967")
    fun givesTheBitsOfTheDepthBuffer(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed).frame()
        val expected = ZBuffer().render(frame)
        val actual = ScanLine().render(frame)
        assertEquals(expected, actual, "AwkwardFrames($seed).frame()")
        assertEquals(expected.counters.fragments, actual.counters.fragments)
        assertEquals(expected.visible.toLong(), actual.counters.shadingCalls)
    }

    @Property(tries = 300, seed = "1967")
    fun givesTheSameBitsUnderEveryCoherence(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed).frame()
        for (coherence in Coherence.entries) {
            val renderer = ScanLine().configured(RenderOptions(coherence))
            assertEquals(ZBuffer().render(frame), renderer.render(frame), "AwkwardFrames($seed).frame(), $coherence")
        }
    }

    @Property(tries = 1500, seed = "1967")
    fun rule_5_5_blendsLikeTheLists(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = LayeredFrames.translucent(seed)
        val expected = Lists().render(frame)
        val actual = ScanLine(RenderOptions(coherence)).render(frame)
        assertEquals(expected, actual, "LayeredFrames.translucent($seed), $coherence")
        assertEquals(expected.counters.fragments, actual.counters.fragments)
        assertEquals(expected.counters.shadingCalls, actual.counters.shadingCalls)
    }
}
