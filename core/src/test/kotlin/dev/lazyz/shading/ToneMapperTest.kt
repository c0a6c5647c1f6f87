package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Contract rule 6.11: exposure and tone curves. */
class ToneMapperTest {
    private fun mapped(curve: ToneMapping.Curve, exposure: Double, vararg color: Float): FloatArray =
        color.copyOf().also { ToneMapper.of(ToneMapping(curve, exposure))!!.apply(it) }

    @Test
    fun rule_6_11_exposureIsInStops() {
        assertArrayEquals(floatArrayOf(2f, 1f, 0.5f), mapped(ToneMapping.Curve.NONE, 2.0, 0.5f, 0.25f, 0.125f))
        assertArrayEquals(floatArrayOf(0.5f, 0.25f, 0.125f), mapped(ToneMapping.Curve.NONE, -1.0, 1f, 0.5f, 0.25f))
        assertNull(ToneMapper.of(ToneMapping.NONE))
        assertThrows(IllegalArgumentException::class.java) { ToneMapping(ToneMapping.Curve.NONE, 20.5) }
        assertThrows(IllegalArgumentException::class.java) { ToneMapping(ToneMapping.Curve.NONE, Double.NaN) }
    }

    @Test
    fun rule_6_11_neutralByHand() {
        // Below the start of compression only the reflectance of dielectrics is subtracted
        assertArrayEquals(
            floatArrayOf(0.46f, 0.26f, 0.06f),
            mapped(ToneMapping.Curve.NEUTRAL, 0.0, 0.5f, 0.3f, 0.1f),
            1e-6f,
        )
        // Offset of a dark colour: x - 6.25 x^2, with x = 0.04
        assertArrayEquals(
            floatArrayOf(0.07f, 0.03f, 0.01f),
            mapped(ToneMapping.Curve.NEUTRAL, 0.0, 0.1f, 0.06f, 0.04f),
            1e-6f,
        )
        // Peak 1.96 becomes 1 - 0.24^2 / (1.96 + 0.24 - 0.76) = 0.96; then 1 - 1 / (0.15 + 1) toward white
        val white = 0.15 / 1.15
        val green = 0.96 / 1.96 * 0.46
        val least = 0.96 / 1.96 * 0.04
        fun faded(part: Double) = (part + (0.96 - part) * white).toFloat()
        val expected = floatArrayOf(0.96f, faded(green), faded(least))
        assertArrayEquals(expected, mapped(ToneMapping.Curve.NEUTRAL, 1.0, 1f, 0.25f, 0.04f), 1e-5f)
    }

    @Test
    fun rule_6_11_acesByHand() {
        val grey = 0.5 * (2.51 * 0.5 + 0.03) / (0.5 * (2.43 * 0.5 + 0.59) + 0.14)
        assertArrayEquals(
            floatArrayOf(grey.toFloat(), 0f, 0f),
            mapped(ToneMapping.Curve.ACES, 0.0, 0.5f, 0f, -1f),
            1e-6f,
        )
    }

    @Test
    fun rule_6_11_notTheBackgroundAndNotCustomShaders() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 9.0)
        val grey = Rgba(0.25f, 0.25f, 0.25f)
        val constant = Sphere(Vector3d(), 1.0, Material(grey, shading = Shading.CONSTANT))
        val shader = Sphere(Vector3d(), 1.0, Material(shader = { it.setColor(0.25f, 0.25f, 0.25f) }))
        fun image(sphere: Sphere) = ZBufferRenderer().render(
            Scene(listOf(sphere), viewpoint = camera, background = grey)
                .withToneMapping(ToneMapping(ToneMapping.Curve.NONE, 1.0)).frame(8, 8),
        )
        assertEquals(grey.toArgb(), image(constant).argb(0, 0))
        assertEquals(Rgba(0.5f, 0.5f, 0.5f).toArgb(), image(constant).argb(4, 4))
        assertEquals(grey.toArgb(), image(shader).argb(4, 4))
    }

    @Test
    fun rule_6_11_neutralIsTheDefaultOfPhysicalMaterialsAlone() {
        fun own(material: Material) = Scene(listOf(Sphere(Vector3d(), 1.0, material))).effectiveToneMapping
        val physical = Material().withMetallicRoughness(MetallicRoughness())
        assertEquals(ToneMapping(ToneMapping.Curve.NEUTRAL), own(physical))
        for (shading in Shading.entries) assertEquals(ToneMapping.NONE, own(Material(shading = shading)))
        assertEquals(ToneMapping.NONE, own(physical.withShading(Shading.CONSTANT)))
        val scene =
            Scene(listOf(Sphere(Vector3d(), 1.0, physical))).withToneMapping(ToneMapping(ToneMapping.Curve.ACES, 2.0))
        assertEquals(ToneMapping(ToneMapping.Curve.ACES, 2.0), scene.effectiveToneMapping)
    }
}
