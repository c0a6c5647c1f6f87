package dev.lazyz.spark.pictures

import dev.lazyz.Rgba
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.spark.TestSpark
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class SparkRendererTest {
    private val renderer = SparkRenderer(TestSpark.session)

    @TestFactory
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun builtInScenesAreThoseOfOneJvm(): List<DynamicTest> = Scenes.builtins.map { builtin ->
        dynamicTest(builtin.id) {
            val frame = builtin.scene().frame(160, 200)
            val expected = (if (frame.hasTranslucency) ListsRenderer() else ZBufferRenderer()).render(frame)
            val image = renderer.render(frame)
            assertEquals(expected, image)
            assertEquals(expected.pixelHash(), image.pixelHash())
        }
    }

    @Test
    fun translucentScenesAreThoseOfOneJvm() {
        val glass = scene {
            for (i in 0 until 12) {
                val color = Rgba.ofRgb(0x204060 + i * 0x0F0501)
                val material = Material(Rgba(color.red, color.green, color.blue, 0.4f), alphaMode = AlphaMode.BLEND)
                add(Sphere(Vector3d(i % 4 * 0.6, i / 4 * 0.6, i * 0.2), 0.5, material))
            }
        }
        val frame = glass.frame(200, 300)
        check(frame.hasTranslucency)
        assertEquals(ListsRenderer().render(frame), renderer.render(frame))
    }

    @Test
    fun exceptionsOfPrimitivesReachTheCaller() {
        val problem = IllegalStateException("no colour today")
        val frame = Scenes.teapot(2).frame(64, 64).observed { _, _, _ -> throw problem }
        assertSame(problem, assertThrows(IllegalStateException::class.java) { renderer.render(frame) })
    }
}
