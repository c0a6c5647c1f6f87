package dev.lazyz.scenes

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.Renderers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/**
 * The identity of every built-in scene's picture, and of those of [GoldenScenes], committed: the machine, the JVM, its
 * compiler and the renderer have no say in a pixel (contract rules 6.3, 7.1 and 7.2). The build runs this class interpreted,
 * too.
 *
 * After a change that is meant to change pictures, look at them, then take the new hashes from the failures.
 */
class GoldenTest {
    private val goldens: Map<String, String> =
        checkNotNull(javaClass.getResource("goldens.txt")).readText().lines()
            .filter { it.isNotBlank() && !it.startsWith("#") }
            .associate { it.substringBeforeLast(' ') to it.substringAfterLast(' ') }

    private val scenes = Scenes.builtins.associate { it.id to it::scene } + GoldenScenes.all

    @TestFactory
    fun rule_7_2_scenesHaveTheirCommittedPixelHash(): List<DynamicTest> = pictures().map { (name, frame) ->
        dynamicTest(name) {
            // One golden for all renderers; without translucency besides, where not all of them blend
            assertHash(name, frame, Renderers.builtIn.filter { !frame.hasTranslucency || it.blends })
            if (frame.hasTranslucency) assertHash("$name opaque", frame.asOpaque(), Renderers.builtIn)
        }
    }

    @Test
    fun everyGoldenHasItsScene() {
        val names = pictures().flatMap { (name, frame) ->
            if (frame.hasTranslucency) listOf(name, "$name opaque") else listOf(name)
        }
        assertEquals(names.toSet(), goldens.keys)
    }

    private fun pictures(): List<Pair<String, Frame>> = scenes.flatMap { (id, scene) ->
        val sizes = if (id in GoldenScenes.all) listOf(96 to 72) else listOf(64 to 64, 160 to 120)
        sizes.map { (width, height) -> "$id ${width}x$height" to scene().frame(width, height) }
    }

    private fun assertHash(name: String, frame: Frame, renderers: List<Renderer>) {
        assertTrue(renderers.isNotEmpty())
        for (renderer in renderers) {
            assertEquals(goldens[name], renderer.render(frame).pixelHash()) { "$name by ${renderer.id}" }
        }
    }

    private val Renderer.blends: Boolean get() = Capability.TRANSPARENCY in capabilities
}
