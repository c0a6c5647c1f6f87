package dev.lazyz.strategies.flow

import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.pipeline.PipelineFrames
import dev.lazyz.strategies.zbuffer.ZBuffer
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals

/** Contract rules 5, 7 and 8: the same picture as the z-buffer's, with the promised amount of work. */
class FlowPipelineProperties {
    @Property(tries = 600, seed = "57", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_thePictureIsTheZBuffers(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = PipelineFrames(seed).next()
        val expected = ZBuffer().render(frame)
        val image = FlowPipeline(RenderOptions(coherence)).render(frame)
        assertEquals(expected, image)
        assertEquals(expected.counters.primitives, image.counters.primitives)
        assertEquals(expected.counters.fragments, image.counters.fragments)
        assertEquals(expected.counters.depthEvaluations, image.counters.depthEvaluations)
        assertEquals(expected.counters.depthPasses, image.counters.depthPasses)
        assertEquals(image.visible.toLong(), image.counters.shadingCalls)
    }
}
