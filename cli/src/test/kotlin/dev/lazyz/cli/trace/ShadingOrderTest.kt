package dev.lazyz.cli.trace

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.cli.output.Mistake
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** In which order strategies shade, and what for nothing. */
class ShadingOrderTest {
    private val frames: Map<String, Frame> =
        Scenes.builtins.associate { it.id to it.scene().frame(96, 64) }.filterValues { !it.hasTranslucency }

    private fun alone(id: String): Renderer {
        val renderer = checkNotNull(Renderers.find(id))
        return renderer.configured(RenderOptions(threads = 1).supportedBy(renderer))
    }

    private fun order(id: String, frame: Frame, budget: Long? = null): ShadingOrder {
        val renderer = alone(id).let { if (budget == null) it else it.configured(RenderOptions(memoryBudget = budget)) }
        val recorder = ShadingOrder.Recorder(frame, id)
        val image = renderer.render(frame.observed(recorder))
        val order = recorder.toOrder()
        assertEquals(image.counters.shadingCalls, order.size.toLong(), id)
        assertEquals(renderer.render(frame).pixelHash(), image.pixelHash(), id)
        return order
    }

    private fun places(order: ShadingOrder) = IntArray(order.size) { order.place(it) }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun lazyShadesInTheOrderOfScanline() {
        assertTrue(frames.size >= 5, "${frames.keys}")
        for ((name, frame) in frames) {
            val rows = places(order("scanline", frame))
            for (id in listOf("lazy", "flow", "lists", "warnock", "hierarchical", "raycast", "bsp")) {
                assertArrayEquals(rows, places(order(id, frame)), "$name: $id")
            }
            assertArrayEquals(rows.sortedArray(), rows, "$name: row by row, from left to right")
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun strategiesThatShadeLateDiscardNothing() {
        for ((name, frame) in frames) {
            val others = listOf(
                "lazy", "flow", "scanline", "tiled", "hybrid", "lists", "warnock", "hierarchical", "raycast", "bsp",
            )
            for (id in others) {
                val order = order(id, frame)
                assertEquals(0, order.discarded, "$name: $id")
            }
        }
    }

    @Test
    fun zbufferAndPainterDiscardWhatIsCoveredLater() {
        for (id in listOf("zbuffer", "painter")) {
            for (name in listOf("city", "teapot")) {
                val frame = frames.getValue(name)
                val order = order(id, frame)
                val visible = places(order("scanline", frame))
                assertTrue(order.discarded > 0, "$name: $id")
                val kept = (0 until order.size).filter { !order.isDiscarded(it) }.map { order.place(it) }
                assertArrayEquals(visible, kept.sorted().toIntArray(), "$name: $id")
            }
        }
    }

    @Test
    fun hybridDiscardsWithABudget() = assertTrue(order("hybrid", frames.getValue("layers"), budget = 0).discarded > 0)

    /** Behind an opaque ball nothing counts; before it, all layers do. */
    @Test
    fun layersThatShowThroughAreKept() {
        val glass = Material(Rgba.ofRgb(0x2F7FD0).withAlpha(0.5f)).withAlphaMode(AlphaMode.BLEND)
        val world = scene {
            add(Sphere(Vector3d(0.0, 0.0, 0.0), 1.0, Material(Rgba.ofRgb(0xD0452F))))
            add(Sphere(Vector3d(0.5, 0.0, 1.0), 0.7, glass))
            add(Sphere(Vector3d(0.5, 0.0, -1.5), 0.7, glass))
        }
        val frame = world.frame(60, 40)
        val able = Renderers.builtIn.filter { Capability.TRANSPARENCY in it.capabilities }.map { it.id }
        val kept = able.associateWith { id ->
            val order = order(id, frame)
            (0 until order.size).filter { !order.isDiscarded(it) }.map { order.place(it) }.sorted()
        }
        assertTrue(able.size >= 4, "$able")
        assertEquals(1, kept.values.toSet().size, "all keep the same fragments")
        val first = kept.values.first()
        assertTrue(first.size > first.toSet().size, "some pixels have several layers")
    }

    @Test
    fun thereIsALimit() {
        val frame = frames.getValue("teapot")
        val recorder = ShadingOrder.Recorder(frame, "lazy", most = 100)
        val mistake = assertThrows(Mistake::class.java) { alone("lazy").render(frame.observed(recorder)) }
        assertTrue("more than 100 shading calls" in mistake.message.orEmpty(), mistake.message)
    }
}
