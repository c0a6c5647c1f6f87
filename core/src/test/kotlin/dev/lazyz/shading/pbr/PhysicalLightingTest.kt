package dev.lazyz.shading.pbr

import dev.lazyz.Checkpoint
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.Workers
import dev.lazyz.setup.SceneSetUp
import dev.lazyz.spi.Fragment
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.8: metallic-roughness materials. */
class PhysicalLightingTest {
    private val eye = Vector3d(0.9, 0.4, 4.0)
    private val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 10.0)
    private val normal = Vector3d(0.1, -0.2, 1.0).normalize()

    /** The linear colour of a point at the world's origin. */
    private fun seen(material: Material, vararg lights: Light, environment: Environment = Environment.NONE): Rgba {
        val light = SceneLight(lights.toList(), lights.toList(), environment, ToneMapping.NONE, null)
        val fragment = Fragment()
        fragment.normalX = 2f * normal.x.toFloat()
        fragment.normalY = 2f * normal.y.toFloat()
        fragment.normalZ = 2f * normal.z.toFloat()
        SceneSetUp(Raster(1, 1), camera, light, Vector3d(), Workers.ALL, Checkpoint.NONE)
            .shader(material).shade(fragment)
        return Rgba(fragment.red, fragment.green, fragment.blue)
    }

    private fun material(color: Rgba, metallic: Float, roughness: Float) =
        Material(color).withMetallicRoughness(MetallicRoughness(metallic, roughness))

    private fun assertColor(expected: List<Double>, actual: Rgba, what: String) {
        for ((wanted, got) in expected.zip(listOf(actual.red, actual.green, actual.blue))) {
            assertEquals(wanted, got.toDouble(), 1e-5 * Math.max(1.0, wanted), what)
        }
    }

    @Test
    fun rule_6_8_asTheSpecificationPrints() {
        val color = listOf(0.9, 0.5, 0.125)
        val view = Vector3d(eye).normalize()
        for (metallic in listOf(0f, 0.25f, 1f)) {
            for (roughness in listOf(0.1f, 0.25f, 0.5f, 0.75f, 1f)) {
                for (toLight in listOf(Vector3d(0.0, 0.0, 1.0), Vector3d(-0.7, -0.6, 1.0), Vector3d(3.0, 1.0, 0.5))) {
                    val light = Light.Directional(Vector3d(toLight).negate(), Rgba(1f, 2f, 0.5f))
                    val own = material(Rgba(0.9f, 0.5f, 0.125f), metallic, roughness)
                    val l = Vector3d(toLight).normalize()
                    val brdf = Appendix.reflected(color, metallic.toDouble(), roughness.toDouble(), normal, l, view)
                    // A light of colour 1 has the illuminance pi
                    val expected = listOf(1.0, 2.0, 0.5).mapIndexed { i, c -> c * Math.PI * brdf[i] }
                    assertColor(expected, seen(own, light), "$metallic, $roughness, $toLight")
                }
            }
        }
    }

    @Test
    fun rule_6_8_lightsAddUpAndEmissionIsAdded() {
        val gold = material(Rgba(1f, 0.75f, 0.25f), 0.5f, 0.5f)
        val sun = Light.Directional(Vector3d(0.5, 0.0, -1.0), Rgba.WHITE)
        val lights = listOf(sun, Light.Ambient(Rgba(0.25f, 0.5f, 1f)))
        val (first, second) = lights.map { seen(gold, it) }
        val both = seen(gold.withEmission(Rgba(0.5f, 3f, 0f)), *lights.toTypedArray())
        assertColor(
            listOf(first.red + second.red + 0.5, first.green + second.green + 3.0, first.blue + second.blue + 0.0),
            both,
            "sum",
        )
        assertColor(listOf(0.0, 0.0, 0.0), seen(gold, Light.Directional(Vector3d(0.0, 0.0, 1.0), Rgba.WHITE)), "behind")
    }

    @Test
    fun rule_6_8_furnaceAWhiteSurfaceReflectsAllLightAndNoMore() {
        val furnace = Light.Ambient(Rgba.WHITE)
        for (roughness in 0..20) {
            for (metallic in listOf(0f, 1f)) {
                val actual = seen(material(Rgba.WHITE, metallic, roughness / 20f), furnace)
                assertTrue(actual.red <= 1.000001f) { "$metallic, $roughness: $actual" }
                assertTrue(actual.red >= 0.99f) { "$metallic, $roughness: $actual" }
            }
            val black = seen(material(Rgba.BLACK, 0f, roughness / 20f), furnace)
            assertTrue(black.red in 0.01f..0.12f) { "$roughness: $black" }
        }
    }

    @Test
    fun rule_6_8_constantShadingAndCustomShadersTakePrecedence() {
        val plain = Material(Rgba(0.5f, 0.25f, 1f), shading = Shading.CONSTANT)
        val sun = Light.Directional(Vector3d(0.0, 0.0, -1.0), Rgba.WHITE)
        val model = MetallicRoughness()
        assertEquals(seen(plain, sun), seen(plain.withMetallicRoughness(model), sun))
        val shaded = Material(shader = { it.setColor(0.125f, 0.25f, 0.5f) }).withMetallicRoughness(model)
        assertEquals(Rgba(0.125f, 0.25f, 0.5f), seen(shaded, sun))
    }

    @Test
    fun rule_6_5_spotsAndFalloff() {
        val white = Material()
        val at = Vector3d(0.0, 0.0, 2.0)
        val down = Vector3d(0.0, 0.0, -1.0)
        val cosine = normal.z
        fun red(light: Light) = seen(white, light).red.toDouble()
        assertEquals(cosine, red(Light.Point(at, Rgba.WHITE)), 1e-6)
        assertEquals(cosine / 4, red(Light.Point(at, Rgba.WHITE, Falloff.inverseSquare())), 1e-6)
        val window = 1.0 - Math.pow(2.0 / 2.5, 4.0)
        assertEquals(cosine / 4 * window, red(Light.Point(at, Rgba.WHITE, Falloff.inverseSquare(2.5))), 1e-6)
        assertEquals(0.0, red(Light.Point(at, Rgba.WHITE, Falloff.inverseSquare(2.0))))
        assertEquals(cosine, red(Light.Spot(at, down, Rgba.WHITE, 10.0, 30.0)), 1e-6)

        // 20 degrees off the axis
        val slanted = Vector3d(Math.sin(Math.toRadians(20.0)), 0.0, -Math.cos(Math.toRadians(20.0)))
        val (c10, c20, c30) = listOf(10.0, 20.0, 30.0).map { Math.cos(Math.toRadians(it)) }
        val edge = Math.pow((c20 - c30) / (c10 - c30), 2.0)
        assertEquals(cosine * edge, red(Light.Spot(at, slanted, Rgba.WHITE, 10.0, 30.0)), 1e-5)
        assertEquals(0.0, red(Light.Spot(at, slanted, Rgba.WHITE, 0.0, 19.0)))
    }
}
