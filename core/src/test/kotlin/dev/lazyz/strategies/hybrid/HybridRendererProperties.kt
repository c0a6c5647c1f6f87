package dev.lazyz.strategies.hybrid

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.render
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import kotlinx.coroutines.flow.asFlow
import kotlinx.coroutines.runBlocking
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.LongRange
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** The hybrid's picture is the z-buffer's, for any budget. */
class HybridRendererProperties {
    @Property(tries = 200, seed = "20260102", edgeCases = EdgeCasesMode.NONE)
    fun anyBudgetGivesTheSamePictureWithinTheBudget(
        @ForAll seed: Long,
        @ForAll @LongRange(min = 0, max = 5000) budget: Long,
        @ForAll coherence: Coherence,
    ) {
        val frame = AwkwardFrames(seed, 24).frame()
        val expected = ZBufferRenderer().render(frame)
        for (bytes in listOf(0L, budget)) {
            val hybrid = HybridRenderer(RenderOptions(coherence, memoryBudget = bytes))
            for (image in listOf(hybrid.render(frame), stream(hybrid, Frame(frame.raster, frame.primitives)))) {
                val whole = if (image.region ==
                    frame.region
                ) {
                    expected
                } else {
                    ZBufferRenderer().render(frame.within(image.region))
                }
                assertEquals(whole, image)
                assertTrue(image.counters.peakBytes <= bytes + 12 * image.region.size) { image.counters.toString() }
                assertTrue(image.counters.shadingCalls in image.visible..whole.counters.shadingCalls)
            }
        }
    }

    private fun stream(hybrid: HybridRenderer, frame: Frame): Image = runBlocking {
        val collector = Image.Collector(frame.region)
        collector.toImage(hybrid.render(frame.raster, frame.primitives.asFlow(), collector))
    }
}
