package dev.lazyz.lighting

import dev.lazyz.Image
import dev.lazyz.Rgba
import dev.lazyz.strategies.zbuffer.ZBuffer
import dev.lazyz.world.Camera
import dev.lazyz.world.Environment
import dev.lazyz.world.Light
import dev.lazyz.world.Material
import dev.lazyz.world.MetallicRoughness
import dev.lazyz.world.Scene
import dev.lazyz.world.Shading
import dev.lazyz.world.Sphere
import dev.lazyz.world.ToneMapping
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class LightRigTest {
    private fun ball(material: Material, light: List<Light> = emptyList()) =
        Scene(listOf(Sphere(Vector3d(), 1.0, material)), light, Camera.fit(40.0, 15.0))

    private fun picture(scene: Scene, rig: LightRig? = null): Image {
        val camera = scene.camera(61, 61)
        return ZBuffer().render((rig?.on(scene, camera) ?: scene).frame(61, 61))
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

    /** White stays darker than a white background, and shapes are visible: neither all black nor all the same. */
    @Test
    fun whiteSurfacesShowTheirShape() {
        val matt = MetallicRoughness(0f, 1f)
        for (rig in LightRig.entries - LightRig.FLAT) {
            for (material in listOf(Material(), Material().withMetallicRoughness(matt))) {
                val greens = visible(picture(ball(material), rig)).map { it ushr 8 and 0xFF }
                assertTrue(greens.max() in 200..250) { "$rig, $material: brightest ${greens.max()}" }
                assertTrue(greens.min() < greens.max() - 40) { "$rig, $material: ${greens.min()}..${greens.max()}" }
            }
        }
    }

    @Test
    fun metalsAreNotBlack() {
        val mirror = Material().withMetallicRoughness(MetallicRoughness(1f, 0.2f))
        for (rig in LightRig.entries - LightRig.FLAT) {
            val mean = visible(picture(ball(mirror), rig)).map { it ushr 8 and 0xFF }.average()
            assertTrue(mean > 60) { "$rig: $mean" }
        }
    }

    @Test
    fun aHeadlightIsSymmetricAndTheSunStaysInPlace() {
        val front = picture(ball(Material()), LightRig.HEADLIGHT)
        for (y in 0 until 61) {
            for (x in 0 until 61) {
                val difference = (front.argb(x, y) and 0xFF) - (front.argb(60 - x, y) and 0xFF)
                assertTrue(difference in -2..2) { "($x, $y): $difference" }
            }
        }
        val turned = ball(Material()).withViewpoint(Camera.fit(220.0, 15.0))
        val (before, after) = listOf(ball(Material()), turned)
            .map { scene -> visible(picture(scene, LightRig.SUN)).map { it and 0xFF }.average() }
        assertTrue(before > after + 8) { "$before, seen from behind $after" }
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
        val shiny = Material(specular = Rgba.WHITE, shininess = 30).asMetallicRoughness()
        assertEquals(0.5f, shiny.metallicRoughness!!.roughness, 1e-6f)
        val metal = Material().withMetallicRoughness(MetallicRoughness(1f, 0.3f))
        assertEquals(metal.metallicRoughness, metal.asMetallicRoughness().metallicRoughness)
        assertEquals(null, Material(shading = Shading.CONSTANT).asMetallicRoughness().metallicRoughness)
        assertEquals(null, Material(shader = { it.setColor(1f, 1f, 1f) }).asMetallicRoughness().metallicRoughness)
    }
}
