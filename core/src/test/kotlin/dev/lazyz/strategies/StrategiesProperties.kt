package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer.Order
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 5, 7 and 8: all strategies give one picture, with the work that they promise. */
class StrategiesProperties {
    private val renderers = Renderers.builtIn + HierarchicalRenderer(order = Order.SUBMISSION)

    /** They leave out hidden primitives before their samples are known, and do not count these. */
    private val rejecting = setOf("tiled", "raycast")

    @Property(tries = 200, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_thePictureIsTheZBuffers(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed).frame()
        val expected = ZBufferRenderer().render(frame)
        for (renderer in renderers) {
            val image = renderer.configured(RenderOptions(coherence).supportedBy(renderer)).render(frame)
            val counters = image.counters
            val what = "AwkwardFrames($seed).frame(), $renderer, $coherence: $counters"
            assertEquals(expected, image, what)
            assertEquals(expected.counters.primitives, counters.primitives, what)
            if (Capability.SHADES_ONLY_VISIBLE in renderer.capabilities) {
                assertEquals(image.visible.toLong(), counters.shadingCalls, what)
            } else {
                assertTrue(counters.shadingCalls >= image.visible, what)
            }
            when (renderer.id) {
                // They reject what is hidden before they know its samples
                "tiled", "raycast" -> assertTrue(counters.fragments <= expected.counters.fragments, what)
                "lazy", "flow" -> assertEquals(expected.counters.depthEvaluations, counters.depthEvaluations, what)
            }
            if (renderer.id !in rejecting) assertEquals(expected.counters.fragments, counters.fragments, what)
            if (renderer.id in setOf("lazy", "flow", "hybrid")) {
                assertEquals(expected.counters.depthPasses, counters.depthPasses, what)
            }
        }
    }

    @Property(tries = 200, seed = "1972", edgeCases = EdgeCasesMode.NONE)
    fun rule_5_5_translucentPrimitivesBlendLikeTheLists(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed, 40).translucent()
        if (!frame.hasTranslucency) return
        val expected = ListsRenderer().render(frame)
        for (renderer in renderers.filter { Capability.TRANSPARENCY in it.capabilities }) {
            val image = renderer.configured(RenderOptions(coherence).supportedBy(renderer)).render(frame)
            val what = "AwkwardFrames($seed, 40).translucent(), $renderer, $coherence"
            assertEquals(expected, image, what)
            if (renderer.id == "tiled") continue
            assertEquals(expected.counters.shadingCalls, image.counters.shadingCalls, what)
            if (renderer.id in rejecting) continue
            assertEquals(expected.counters.fragments, image.counters.fragments, what)
        }
    }
}
