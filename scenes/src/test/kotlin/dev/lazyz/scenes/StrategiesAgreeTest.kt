package dev.lazyz.scenes

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.meshes.AwkwardMesh
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Material
import dev.lazyz.world.Scene
import dev.lazyz.world.Shading
import dev.lazyz.world.Sides
import dev.lazyz.world.Texture
import dev.lazyz.world.TextureFilter
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/** Contract rule 7.1: all renderers give the same bits of every built-in scene, of an awkward mesh, of real ones. */
class StrategiesAgreeTest {
    @TestFactory
    fun rule_7_1_onEveryBuiltinScene(): List<DynamicTest> = Scenes.builtins.map { builtin ->
        dynamicTest(builtin.id) { assertAgree(builtin.scene()) }
    }

    @TestFactory
    fun rule_7_1_onAnAwkwardMesh(): List<DynamicTest> = Shading.entries.flatMap { shading ->
        AlphaMode.entries.map { mode ->
            dynamicTest("$shading, $mode") {
                val texture = Texture(2, 2, intArrayOf(-1, 0x40FF8000, 0x7F00FF00, -0xFF8001), TextureFilter.BILINEAR)
                val sides = if (mode == AlphaMode.OPAQUE) Sides.FRONT else Sides.BOTH
                val material = Material(
                    Rgba(0.9f, 0.8f, 0.7f, 0.75f), texture, shading, Rgba(0.3f, 0.3f, 0.3f),
                    alphaMode = mode, sides = sides,
                )
                assertAgree(Scene(listOf(AwkwardMesh.of(material))))
            }
        }
    }

    @TestFactory
    fun rule_7_1_onRealMeshes(): List<DynamicTest> = MODELS.map { name ->
        dynamicTest(name) { assertAgree(Scenes.load(TestSources.modelPath(name)).scene) }
    }

    private fun assertAgree(scene: Scene) {
        val frame = scene.frame(67, 131)
        assertAgree(frame.asOpaque(), Renderers.builtIn.map { it.id })
        if (!frame.hasTranslucency) return
        assertAgree(frame, Renderers.builtIn.filter { Capability.TRANSPARENCY in it.capabilities }.map { it.id })
    }

    private fun assertAgree(frame: Frame, ids: List<String>) {
        assertTrue(ids.isNotEmpty())
        val expected = Renderers.find(ids.first())!!.render(frame)
        assertTrue(expected.visible > 0)
        for (id in ids) assertEquals(expected, Renderers.find(id)!!.render(frame), id)
    }

    private companion object {
        val MODELS = listOf(
            "2CylinderEngine.glb", "BoxTextured.glb", "bunny.obj", "cow.obj", "igea.ply", "spider-ascii.stl",
            "spider-binary.stl", "spider.obj", "spot.obj", "teapot.obj",
        )
    }
}
