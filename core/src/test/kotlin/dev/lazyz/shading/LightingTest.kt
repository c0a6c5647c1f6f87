package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.5: ambient light, Lambert's cosine, and highlights. */
class LightingTest {
    private val camera = Camera.perspective(
        Vector3d(0.0, 0.0, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 10.0,
    )

    /** The linear colour of a large wall at z = 0, at the centre of a 1 x 1 raster. */
    private fun seen(material: Material, vararg lights: Light): Rgba = color(shaded(material, Z, lights.toList()))

    private fun color(fragment: Fragment): Rgba = Rgba(fragment.red, fragment.green, fragment.blue, fragment.alpha)

    private fun shaded(material: Material, normal: Vector3d, lights: List<Light>): Fragment {
        val normals = FloatArray(9) { normal[it % 3].toFloat() }
        val wall = Mesh(floatArrayOf(-9f, -9f, 0f, 9f, -9f, 0f, 0f, 12f, 0f), intArrayOf(0, 1, 2), material, normals)
        val frame = Scene(listOf(wall), lights, camera).frame(1, 1)
        val fragment = Fragment()
        fragment.moveTo(0, 0)
        frame.primitives.single().shade(fragment)
        return fragment
    }

    private fun assertColor(red: Double, green: Double, blue: Double, actual: Rgba) {
        val difference = listOf(actual.red - red, actual.green - green, actual.blue - blue)
        assertTrue(difference.all { Math.abs(it) < 2e-6 }) { "$actual instead of $red, $green, $blue" }
    }

    @Test
    fun rule_6_5_withoutLightThereIsEmissionAlone() {
        val dark = Light.Ambient(Rgba.BLACK)
        for (shading in Shading.entries - Shading.CONSTANT) {
            val material = Material(shading = shading, emission = Rgba(0.1f, 0.2f, 0.3f), specular = Rgba.WHITE)
            assertColor(0.1, 0.2, 0.3, seen(material, dark))
        }
        val constant = Material(Rgba(0.5f, 0.5f, 0.5f), shading = Shading.CONSTANT, emission = Rgba(0.1f, 0.2f, 0.3f))
        assertColor(0.6, 0.7, 0.8, seen(constant, dark))
    }

    @Test
    fun rule_6_5_highlightsByHand() {
        // Light from 60 degrees off the line of sight, which is the normal
        val light = Light.Directional(Vector3d(-StrictMath.sqrt(3.0), 0.0, -1.0), Rgba.WHITE)
        val black = Material(Rgba.BLACK, specular = Rgba(1f, 0.5f, 0.25f), shininess = 3)
        // Phong: the angle of reflected ray and viewer is 60 degrees, (1/2)^3
        assertColor(0.125, 0.0625, 0.03125, seen(black, light))
        // Blinn: the angle of normal and halfway vector is 30 degrees, (3/4)^(3/2)
        val strength = StrictMath.pow(0.75, 1.5)
        assertColor(strength, strength / 2, strength / 4, seen(black.withShading(Shading.BLINN_PHONG), light))
    }

    @Test
    fun rule_6_5_aNormalWithoutLengthPointsToTheViewer() {
        val light = Light.Directional(Vector3d(StrictMath.sqrt(3.0), 0.0, -1.0), Rgba.WHITE)
        for (shading in listOf(Shading.PHONG, Shading.BLINN_PHONG)) {
            val fragment = shaded(Material(shading = shading), Vector3d(), listOf(light))
            assertColor(0.5, 0.5, 0.5, color(fragment))
        }
    }

    private companion object {
        val Z = Vector3d(0.0, 0.0, 1.0)
    }
}
