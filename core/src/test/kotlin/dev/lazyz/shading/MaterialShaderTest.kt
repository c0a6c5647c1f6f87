package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.setup.lightOf
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Contract rule 6.1 for materials: single fragments and batches, of meshes and of polygons, have the same colours. */
class MaterialShaderTest {
    private val texture = Texture(2, 2, intArrayOf(-0x1, 0x40ff0000, 0x4000ff00, -0xffff01), Texture.Filter.BILINEAR)
    private val lights = listOf(
        Light.Ambient(Rgba(0.1f, 0.2f, 0.3f)), Light.Directional(Vector3d(-1.0, -2.0, -3.0), Rgba(0.7f, 0.6f, 0.5f)),
    )
    private val camera =
        Camera.perspective(Vector3d(0.3, 0.4, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 10.0)

    private fun materials(): List<Material> = Shading.entries.flatMap { shading ->
        AlphaMode.entries.flatMap { mode ->
            listOf(null, texture).map { texture ->
                Material(
                    Rgba(0.9f, 0.8f, 0.7f, 0.6f), texture, shading, Rgba(0.3f, 0.2f, 0.1f), 8,
                    Rgba(0.1f, 0.2f, 0.3f), mode,
                )
            }
        }
    }

    @Test
    fun rule_6_1_aBatchIsColouredAsItsFragmentsOneByOne() {
        val random = Random(6)
        for (material in materials()) {
            for (isPrelit in listOf(false, true)) {
                val shader: BatchShader = MaterialShader(material, Lighting(lightOf(lights), camera), isPrelit)
                val batch = FragmentBatch.of(5)
                val fields = listOf(
                    batch.worldX, batch.worldY, batch.worldZ, batch.normalX, batch.normalY, batch.normalZ,
                    batch.u, batch.v, batch.vertexRed, batch.vertexGreen, batch.vertexBlue, batch.vertexAlpha,
                )
                for (array in fields) for (i in 0 until 5) array[i] = random.nextFloat()
                shader.shade(batch)
                for (i in 0 until 5) {
                    val fragment = Fragment()
                    batch.moveTo(fragment, i)
                    shader.shade(fragment)
                    val colors = listOf(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])
                    assertEquals(listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha), colors) {
                        "${material.shading}, ${material.alphaMode}, ${material.texture}"
                    }
                }
                // Elements after the last fragment are unchanged
                assertEquals(listOf(0f, 1f), listOf(batch.red[5], batch.alpha[5]))
            }
        }
    }

    @Test
    fun aShaderOfOnesOwnSeesTextureCoordinatesWithoutATexture() {
        val material = Material(shader = { it.setColor(it.u, it.v, it.vertexRed) })
        val positions = floatArrayOf(-9f, -9f, 0f, 9f, -9f, 0f, 0f, 12f, 0f)
        val uvs = FloatArray(6) { if (it % 2 == 0) 0.75f else -3f }
        val mesh = Mesh(positions, intArrayOf(0, 1, 2), material, uvs = uvs)
        val fragment = Fragment()
        Scene(listOf(mesh), lights, camera).frame(1, 1).primitives.single().shade(fragment)
        assertEquals(listOf(0.75f, -3f, 1f), listOf(fragment.red, fragment.green, fragment.blue))
    }

    /** Filters round an alpha that is the same everywhere. */
    @Test
    fun rule_2_7_aTextureWhoseAlphaIsTheCutoffHasNoHoles() {
        val eye = Vector3d(0.0, 0.3, 2.0)
        val camera = Camera.perspective(eye, Vector3d(0.0, 0.2, 0.0), Vector3d(0.0, 1.0, 0.0), 50.0, 0.1, 100.0)
        val positions = floatArrayOf(-1f, 0f, -20f, 1f, 0f, -20f, 1f, 0f, 1f, -1f, 0f, 1f)
        val uvs = floatArrayOf(0f, 40f, 4f, 40f, 4f, 0f, 0f, 0f)
        for (alpha in listOf(255, 51)) {
            for (filter in MipFilter.entries) {
                val even = Texture(64, 64, IntArray(64 * 64) { alpha shl 24 or 0xFFFFFF }).withMipFilter(filter)
                val masked = Material(Rgba.WHITE, even).withAlphaMode(AlphaMode.MASK).withAlphaCutoff(alpha / 255f)
                val (covered, all) = listOf(masked, masked.withAlphaMode(AlphaMode.OPAQUE)).map {
                    val floor = Mesh(positions, intArrayOf(0, 1, 2, 0, 2, 3), it, null, uvs)
                    ZBufferRenderer().render(Scene(listOf(floor), lights, camera).frame(100, 100)).visible
                }
                assertEquals(all, covered, "alpha $alpha, $filter")
            }
        }
    }
}
