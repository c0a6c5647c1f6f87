package dev.lazyz.scenes

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Rgba
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.meshes.AwkwardMesh
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/** Contract rule 7.1: all renderers give the same bits of every built-in scene and of an awkward mesh. */
class StrategiesAgreeTest {
    @TestFactory
    fun rule_7_1_onEveryBuiltinScene(): List<DynamicTest> = Scenes.builtins.map { builtin ->
        dynamicTest(builtin.id) { assertAgree(builtin.scene()) }
    }

    @TestFactory
    fun rule_7_1_onAnAwkwardMesh(): List<DynamicTest> = Shading.entries.flatMap { shading ->
        AlphaMode.entries.map { mode ->
            dynamicTest("$shading, $mode") {
                val texture = Texture(2, 2, intArrayOf(-1, 0x40FF8000, 0x7F00FF00, -0xFF8001), Texture.Filter.BILINEAR)
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
    fun rule_7_1_onPhysicallyBasedMaterials(): List<DynamicTest> = AlphaMode.entries.flatMap { mode ->
        listOf(true, false).map { hasLights ->
            dynamicTest("$mode, ${if (hasLights) "lights" else "studio"}") {
                for (hasLobes in listOf(false, true)) {
                    val scene = Scene(listOf(physical(mode, hasLobes)))
                        .withToneMapping(ToneMapping(ToneMapping.Curve.ACES, 0.5))
                    val lit = scene.withLights(LIGHTS).withEnvironment(Environment.studio(0.5f))
                    assertAgree(if (hasLights) lit else scene)
                }
            }
        }
    }

    /** The awkward mesh with all maps, two sets of texture coordinates, and tangents. */
    private fun physical(mode: AlphaMode, hasLobes: Boolean): Mesh {
        val random = Random(7)
        fun map(set: Int, encoding: Texture.Encoding) = TextureMap(
            Texture(3, 5, IntArray(15) { random.nextInt() }, encoding = encoding),
            set,
            UvTransform(1.5, -0.5, 30.0 * set, 0.25, 0.125),
        )
        val lobes = Lobes(
            Lobes.Specular(0.9f, Rgba(0.5f, 1f, 0.75f), 1.4f, map(0, Texture.Encoding.LINEAR)),
            Lobes.Sheen(Rgba(0.25f, 0.5f, 0.75f), 0.5f, map(1, Texture.Encoding.SRGB)),
            Lobes.Clearcoat(0.5f, 0.5f, normalMap = NormalMap(map(1, Texture.Encoding.LINEAR))),
            Lobes.Transmission(0.5f, null, 1f, map(0, Texture.Encoding.LINEAR), Rgba(0.5f, 0.75f, 1f), 2f),
            Lobes.Iridescence(0.5f, thicknessMap = map(0, Texture.Encoding.LINEAR)),
            Lobes.Anisotropy(0.5f, 30f, map(1, Texture.Encoding.LINEAR)),
        ).takeIf { hasLobes }
        val material = Material(Rgba(0.9f, 0.8f, 0.7f, 0.75f), emission = Rgba(0.5f, 1f, 2f), alphaMode = mode)
            .withTextureMap(map(1, Texture.Encoding.SRGB))
            .withMetallicRoughness(MetallicRoughness(0.75f, 0.5f, map(0, Texture.Encoding.LINEAR), lobes))
            .withNormalMap(NormalMap(map(1, Texture.Encoding.LINEAR), 0.5f))
            .withOcclusionMap(OcclusionMap(map(0, Texture.Encoding.LINEAR), 0.5f))
            .withEmissionMap(map(1, Texture.Encoding.SRGB))
        val mesh = AwkwardMesh.of(material)
        val uvs2 = FloatArray(2 * mesh.vertexCount) { random.nextFloat() * 4 - 2 }
        return Mesh(mesh.positions, mesh.triangles, material, mesh.normals, mesh.uvs, uvs2 = uvs2)
            .withTangents(1, checkNotNull(material.normalMap).map.transform)
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
        val LIGHTS = listOf(
            Light.Ambient(Rgba(0.1f, 0.1f, 0.2f)),
            Light.Directional(Vector3d(-1.0, -2.0, -4.0), Rgba(0.6f, 0.5f, 0.4f)),
            Light.Point(Vector3d(1.5, 1.0, 2.5), Rgba(3f, 5f, 4f), Falloff.inverseSquare(6.0)),
            Light.Spot(Vector3d(-2.0, 2.0, 1.0), Vector3d(2.0, -2.0, -1.0), Rgba(2f, 2f, 1f), 10.0, 30.0),
        )
    }
}
