package dev.lazyz.lighting

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Mesh
import kotlin.math.sqrt
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class LightMeterTest {
    /** A square of side [side] in two triangles. */
    private fun square(material: Material, side: Float = 1f, colors: FloatArray? = null) = Mesh(
        floatArrayOf(0f, 0f, 0f, side, 0f, 0f, side, side, 0f, 0f, side, 0f), intArrayOf(0, 1, 2, 0, 2, 3), material,
        uvs = floatArrayOf(0f, 1f, 1f, 1f, 1f, 0f, 0f, 0f), colors = colors,
    )

    private fun grey(linear: Float) = Rgba(linear, linear, linear)

    private fun intensity(vararg meshes: Mesh) = LightMeter.intensity(Scene(meshes.toList()))

    private fun expected(luminance: Double) = sqrt(0.18 / luminance).toFloat()

    @Test
    fun darkOnesGetTheSquareRootOfWhatIsMissing() {
        assertEquals(2f, intensity(square(Material(grey(0.045f)))), 1e-5f)
        assertEquals(expected(0.0722 * 0.5), intensity(square(Material(Rgba(0f, 0f, 0.5f)))), 1e-5f)
        assertEquals(3f, intensity(square(Material(Rgba.BLACK))))
    }

    @Test
    fun areasAreTheWeights() {
        val both = intensity(square(Material(grey(0.1f))), square(Material(grey(0.03f)), side = 3f))
        assertEquals(expected((0.1 + 9 * 0.03) / 10), both, 1e-5f)
    }

    @Test
    fun texturesAndVertexColoursAreMultiplied() {
        // Left half black, right half white: the middles of the triangles are at u = 2/3 and 1/3
        val texels = IntArray(64) { if (it % 8 < 4) 0xFF shl 24 else -1 }
        val texture = Texture(8, 8, texels, Texture.Filter.NEAREST)
        assertEquals(expected(0.05), intensity(square(Material(grey(0.1f), texture))), 1e-5f)
        val moved = TextureMap(texture, transform = UvTransform(offsetU = 0.5))
        assertEquals(expected(0.05), intensity(square(Material(grey(0.1f)).withTextureMap(moved))), 1e-5f)
        val dark = square(Material(grey(0.5f)), colors = FloatArray(16) { 0.1f })
        assertEquals(expected(0.05), intensity(dark), 1e-5f)
    }

    @Test
    fun onlyLitSurfacesCount() {
        val unlit = square(Material(grey(0.01f), shading = Shading.CONSTANT), side = 10f)
        val custom = square(Material(grey(0.01f), shader = { it.setColor(0f, 0f, 0f) }), side = 10f)
        assertEquals(1f, intensity(unlit, custom, square(Material(grey(0.5f)))))
        assertEquals(2f, intensity(unlit, custom, square(Material(grey(0.045f)))), 1e-5f)
    }

    @Test
    fun brokenVerticesDoNotMatter() {
        val wild = Mesh(
            floatArrayOf(0f, 0f, 0f, Float.NaN, 0f, 0f, 0f, Float.POSITIVE_INFINITY, 0f), intArrayOf(0, 1, 2, 0, 0, 0),
            Material(grey(0.01f)),
        )
        assertEquals(1f, intensity(wild))
        assertEquals(2f, intensity(wild, square(Material(grey(0.045f)))), 1e-5f)
        val bright = square(Material(grey(Float.POSITIVE_INFINITY)))
        assertEquals(2f, intensity(bright, square(Material(grey(0.045f)))), 1e-5f)
    }

    /** Of a mesh with more than 65,536 triangles, every n-th is measured; here, only these are dark. */
    @Test
    fun largeMeshesAreMeasuredInPart() {
        val corners = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
        val colors = FloatArray(24) { if (it < 12) 0.1f else 1f }
        for ((triangles, step) in listOf(65_536 to 1, 65_537 to 2, 200_001 to 4)) {
            val indices = IntArray(3 * triangles) { if (it / 3 % step == 0) it % 3 else 3 + it % 3 }
            val mesh = Mesh(corners + corners, indices, Material(grey(0.45f)), colors = colors)
            assertEquals(2f, intensity(mesh), 1e-3f) { "$triangles triangles" }
        }
    }
}
