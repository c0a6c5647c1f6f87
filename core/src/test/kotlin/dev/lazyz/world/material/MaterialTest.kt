package dev.lazyz.world.material

import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.samples
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Contract rules 2.7 and 6.2: masks, sides, and the input of a shader. */
class MaterialTest {
    private val camera = Camera.orthographic(
        Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 9.0,
    )

    /** A square as large as the view that faces the camera; its texture is upright. */
    private fun square(material: Material, isTurned: Boolean = false, z: Float = 0f): Mesh = Mesh(
        floatArrayOf(-2f, -2f, z, 2f, -2f, z, 2f, 2f, z, -2f, 2f, z),
        if (isTurned) intArrayOf(2, 1, 0, 3, 2, 0) else intArrayOf(0, 1, 2, 0, 2, 3),
        material,
        uvs = floatArrayOf(0f, 1f, 1f, 1f, 1f, 0f, 0f, 0f),
    )

    private fun image(vararg surfaces: Surface, size: Int = 8): Image =
        ZBufferRenderer().render(Scene(surfaces.toList(), listOf(Light.Ambient(Rgba.WHITE)), camera).frame(size, size))

    @Test
    fun rule_2_7_aMaskIsCoverage() {
        val half = Texture(2, 1, intArrayOf(0x7FFF0000, 0x80FF0000.toInt()), Texture.Filter.NEAREST)
        for (shading in Shading.entries) {
            val masked = Material(texture = half, shading = shading, alphaMode = AlphaMode.MASK)
            val green = Material(Rgba(0f, 1f, 0f), shading = Shading.CONSTANT)
            val image = image(square(masked, z = 1f), square(green))
            for (y in 0 until 8) {
                for (x in 0 until 8) {
                    val expected = if (x < 4) 0xFF00FF00.toInt() else 0xFFFF0000.toInt()
                    assertEquals(expected, image.argb(x, y)) { "$shading $x, $y" }
                }
            }
            assertEquals(32 + 64, image.counters.fragments)
        }
    }

    @Test
    fun rule_2_7_theCutoffIsCovered() {
        fun covered(alpha: Float, cutoff: Float): Int =
            image(square(Material(Rgba(1f, 1f, 1f, alpha), alphaMode = AlphaMode.MASK, alphaCutoff = cutoff))).visible
        assertEquals(64, covered(0.5f, 0.5f))
        assertEquals(0, covered(0.5f - 0.5f / (1 shl 17), 0.5f))
        assertEquals(64, covered(0f, 0f))
        assertEquals(64, covered(1f, 1f))
    }

    @Test
    fun alphaIsKeptUnderBlendAlone() {
        for (shading in Shading.entries) {
            for (mode in AlphaMode.entries) {
                val material = Material(Rgba(1f, 1f, 1f, 0.6f), shading = shading, alphaMode = mode)
                val expected = if (mode == AlphaMode.BLEND) 153 else 255
                val frame = Scene(listOf(square(material)), viewpoint = camera).frame(8, 8)
                val unblended = ListsRenderer(RenderOptions(selector = Selector.nearest())).render(frame)
                assertEquals(expected, unblended.argb(3, 3) ushr 24) { "$shading $mode" }
                assertEquals(mode == AlphaMode.BLEND, material.isTranslucent)
            }
        }
    }

    @Test
    fun rule_6_2_aShaderSeesAttributes() {
        val shader = Shader { it.setColor(it.u, it.v, it.worldX, it.worldY) }
        val frame = Scene(listOf(square(Material(shader = shader))), viewpoint = camera).frame(8, 8)
        val fragment = Fragment()
        for (primitive in frame.primitives) {
            val covered = primitive.samples(frame.raster)
            for (y in 0 until 8) {
                for (x in 0 until 8) {
                    if (!covered[x, y]) continue
                    fragment.moveTo(x, y)
                    primitive.shade(fragment)
                    assertEquals((x + 0.5f) / 8, fragment.red, 1e-7f)
                    assertEquals((y + 0.5f) / 8, fragment.green, 1e-7f)
                    assertEquals((x + 0.5f) / 2 - 2, fragment.blue, 1e-6f)
                    assertEquals(2 - (y + 0.5f) / 2, fragment.alpha, 1e-6f)
                    assertEquals(1f, fragment.normalZ, 1e-6f)
                    assertEquals(1f, fragment.vertexRed)
                }
            }
        }
    }

    @Test
    fun wrongNumbersAreRefused() {
        fun refused(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block)
        refused { Material(shininess = 0) }
        refused { Material(shininess = 1025) }
        refused { Material(alphaCutoff = -0.1f) }
        refused { Material(alphaCutoff = Float.NaN) }
        refused { Light.Directional(Vector3d(), Rgba.WHITE) }
        refused { Light.Point(Vector3d(Double.NaN), Rgba.WHITE) }
    }
}
