package dev.lazyz.lighting

import dev.lazyz.Image
import dev.lazyz.Rgba
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Camera
import dev.lazyz.world.Environment
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.Sphere
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
    fun lightsAreAddedToWhatMetalsReflect() {
        val mirror = Material().withMetallicRoughness(MetallicRoughness(1f, 0.2f))
        val lamp = listOf(Light.Point(Vector3d(2.0, 3.0, 4.0), Rgba(0.1f, 0.1f, 0.1f)))
        fun mean(scene: Scene) = visible(picture(scene)).map { it ushr 8 and 0xFF }.average()
        val faint = ball(mirror, lamp)
        assertEquals(picture(faint.withEnvironment(Environment.FAINT)), picture(faint))
        assertTrue(mean(faint) > 60) { "${mean(faint)}" }
        assertTrue(mean(faint.withEnvironment(Environment.NONE)) < 30)
    }

    /** A light with a direction, along the axes of a camera. */
    private class Beam(light: Light.Directional, camera: Camera) {
        private val to = Vector3d(light.direction).negate().normalize()

        /** Where the light comes from: to the right, above and in front, from the camera's point of view. */
        val right = to.dot(camera.toWorldDirection(1.0, 0.0, 0.0))
        val above = to.dot(camera.toWorldDirection(0.0, 1.0, 0.0))
        val front = to.dot(camera.toWorldDirection(0.0, 0.0, 1.0))
        val color = light.color

        val isWarm get() = color.red > color.green && color.green > color.blue
        val isCool get() = color.red < color.green && color.green < color.blue
    }

    private fun beams(rig: LightRig, camera: Camera): List<Beam> =
        rig.lights(camera).filterIsInstance<Light.Directional>().map { Beam(it, camera) }

    private fun ambient(rig: LightRig, camera: Camera): Rgba = rig.lights(camera).single { it is Light.Ambient }.color

    private val cameras = listOf(Camera.fit(0.0, 0.0), Camera.fit(130.0, 35.0), Camera.fit(-80.0, -60.0))
        .map { it.camera(ball(Material()), 1.0) }

    /** Which light comes from where, and its colour, from each side of the scene. */
    @Test
    fun threePointsAreAWarmKeyACoolFillAndARim() {
        for (camera in cameras) {
            val (key, fill, rim) = beams(LightRig.THREE_POINT, camera)
            assertTrue(key.right < -0.4 && key.above > 0.4 && key.front > 0.4 && key.isWarm)
            assertTrue(fill.right > 0.6 && fill.above in -0.2..0.4 && fill.front > 0.4 && fill.isCool)
            assertTrue(fill.color.blue < 0.5f * key.color.blue)
            assertTrue(rim.above > 0.4 && rim.front < -0.4 && rim.color.green > fill.color.green)
            assertTrue(ambient(LightRig.THREE_POINT, camera).blue < 0.3f * fill.color.blue)
        }
        assertEquals(Environment.studio(0.2f), LightRig.THREE_POINT.environment)
    }

    @Test
    fun theHeadlightIsWhiteAndAtTheCamera() {
        for (camera in cameras) {
            val light = beams(LightRig.HEADLIGHT, camera).single()
            assertEquals(1.0, light.front, 1e-9)
            for (color in listOf(light.color, ambient(LightRig.HEADLIGHT, camera))) {
                assertEquals(color.green, color.red)
                assertEquals(color.green, color.blue)
            }
            assertTrue(ambient(LightRig.HEADLIGHT, camera).green < 0.1f * light.color.green)
        }
        assertEquals(Environment.studio(0.15f), LightRig.HEADLIGHT.environment)
    }

    @Test
    fun theSunIsWarmHighAndAtTheFrontLeftOfTheSceneUnderABlueSky() {
        val front = cameras[0]
        val sun = beams(LightRig.SUN, front).single()
        assertTrue(sun.right < -0.3 && sun.above > 0.6 && sun.front > 0.3 && sun.isWarm)
        val sky = ambient(LightRig.SUN, front)
        assertTrue(sky.red < sky.green && sky.green < sky.blue && sky.blue < 0.5f * sun.color.blue)
        assertEquals(Environment.studio(0.2f), LightRig.SUN.environment)
        for (camera in cameras) {
            val light = LightRig.SUN.lights(camera).filterIsInstance<Light.Directional>().single()
            val from = front.toWorldDirection(sun.right, sun.above, sun.front)
            assertTrue(from.negate().distance(light.direction) < 1e-9)
        }
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
