package dev.lazyz.lighting

import dev.lazyz.Image
import dev.lazyz.Rgba
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class LightRigTest {
    private fun ball(material: Material, light: List<Light> = emptyList()) =
        Scene(listOf(Sphere(Vector3d(), 1.0, material)), light, Camera.fit(40.0, 15.0))

    private fun picture(scene: Scene, rig: LightRig? = null): Image {
        val camera = scene.camera(61, 61)
        return ZBufferRenderer().render((rig?.on(scene, camera) ?: scene).frame(61, 61))
    }

    private fun visible(image: Image) = image.argb.indices.filter { image.primitive[it] >= 0 }.map { image.argb[it] }

    @Test
    fun studioIsTheLightOfScenesWithoutLights() {
        for (material in listOf(Material(), Material().withMetallicRoughness(MetallicRoughness(1f, 0.4f)))) {
            val own = ball(material, listOf(Light.Ambient(Rgba.WHITE)))
            assertEquals(picture(ball(material)), picture(own, LightRig.STUDIO))
        }
    }

    @Test
    fun flatLightShowsBaseColours() {
        val color = Rgba.ofRgb(0x40A0C0)
        assertEquals(setOf(color.toArgb()), visible(picture(ball(Material(color)), LightRig.FLAT)).toSet())
    }

    /** Light is linear: doubled light gives doubled colours, for all kinds of light and materials. */
    @Test
    fun intensityMultipliesAllLight() {
        val lights = listOf(
            Light.Ambient(Rgba(0.1f, 0.1f, 0.1f)), Light.Point(Vector3d(2.0, 3.0, 4.0), Rgba(0.1f, 0.2f, 0.3f)),
        )
        val physical = Material(Rgba(0.3f, 0.3f, 0.3f)).withMetallicRoughness(MetallicRoughness(0.5f, 0.5f))
        for (material in listOf(Material(Rgba(0.3f, 0.3f, 0.3f)), physical)) {
            for (scene in listOf(ball(material), ball(material, lights).withEnvironment(Environment.studio(0.2f)))) {
                val plain = scene.withToneMapping(ToneMapping.NONE)
                val once = visible(picture(plain)).map { Rgba.ofArgb(it).green }
                val twice = visible(picture(plain.withLightIntensity(2f))).map { Rgba.ofArgb(it).green }
                for ((a, b) in once.zip(twice)) assertEquals(minOf(2 * a, 1f), b, 0.02f)
                assertEquals(picture(plain), picture(plain.withLightIntensity(1f)))
            }
        }
        for (bad in listOf(-0.1f, Float.NaN, Float.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { ball(Material()).withLightIntensity(bad) }
        }
    }

    @Test
    fun classicalMaterialsHaveAPhysicalLikeness() {
        val matt = Material(Rgba(0.5f, 0.2f, 0.1f)).asMetallicRoughness()
        assertEquals(MetallicRoughness(0f, 1f), matt.metallicRoughness)
        assertEquals(Rgba(0.5f, 0.2f, 0.1f), matt.baseColor)
        val shiny = Material(specular = Rgba.WHITE, shininess = 30).asMetallicRoughness()
        assertEquals(0.5f, shiny.metallicRoughness!!.roughness, 1e-6f)
        for (specular in listOf(Rgba(0.1f, 0f, 0f), Rgba(0f, 0.1f, 0f), Rgba(0f, 0f, 0.1f))) {
            val highlit = Material(specular = specular, shininess = 30).asMetallicRoughness()
            assertEquals(shiny.metallicRoughness, highlit.metallicRoughness)
        }
        val metal = Material().withMetallicRoughness(MetallicRoughness(1f, 0.3f))
        assertEquals(metal.metallicRoughness, metal.asMetallicRoughness().metallicRoughness)
        assertEquals(null, Material(shading = Shading.CONSTANT).asMetallicRoughness().metallicRoughness)
        assertEquals(null, Material(shader = { it.setColor(1f, 1f, 1f) }).asMetallicRoughness().metallicRoughness)
    }
}
