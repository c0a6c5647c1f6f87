package dev.lazyz

import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.pipeline.Pane
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Texture
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import kotlinx.coroutines.flow.flowOf
import kotlinx.coroutines.runBlocking
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

/** Contract rule 5.6: which primitives are translucent, and which renderers refuse them. */
class TranslucencyTest {
    private val raster = Raster(4, 3)
    private val wall = Pane(raster.region, 2000, Rgba.BLACK)
    private val glass = Pane(raster.region, 1000, Rgba(1f, 0.5f, 0.25f, 0.5f))
    private val frame = Frame(raster, listOf(wall, glass))
    private val noRows = RowSink { _, _, _, _ -> error("a row was handed out") }

    @Test
    fun rule_5_6_primitivesOfAStreamAreRefusedAsTheyArrive() {
        val error = assertThrows<IllegalArgumentException> {
            runBlocking { ZBufferRenderer().render(raster, flowOf(wall, glass), noRows) }
        }
        assertTrue(error.message!!.startsWith("primitive 1 is translucent"), error.message)
        assertThrows<IllegalArgumentException> {
            runBlocking { HybridRenderer().render(raster, flowOf(wall, glass), noRows) }
        }
        assertEquals(0, glass.shadingCalls)
    }

    @Test
    fun rule_5_6_asOpaqueGivesAFrameThatAllRenderersDrawAlike() {
        val opaque = frame.asOpaque()
        assertFalse(opaque.hasTranslucency)
        val images = Renderers.builtIn.map { it.render(opaque) }
        for (image in images) {
            assertEquals(images[0], image)
            assertEquals(Rgba(1f, 0.5f, 0.25f).toArgb(), image.argb(2, 1))
            assertEquals(1, image.primitive(2, 1))
        }
    }

    @Test
    fun steppedShadingOfAnOpaquePrimitiveIsOpaqueToo() {
        val frame = scene(material(0.5f), null).frame(24, 24).asOpaque()
        val direct = ZBufferRenderer().render(frame)
        assertTrue(direct.argb.all { it ushr 24 == 0xFF })
        assertEquals(direct, HybridRenderer(RenderOptions(Coherence.INCREMENTAL)).render(frame))
    }

    @Test
    fun materialsAreTranslucentIfTheyBlendAndSomethingIsBelowOne() {
        assertFalse(scene(material(1f), null).frame(9, 9).hasTranslucency)
        assertTrue(scene(material(0.5f), null).frame(9, 9).hasTranslucency)
        assertFalse(scene(Material(Rgba.WHITE.withAlpha(0.5f)), null).frame(9, 9).hasTranslucency)
        val clear = Texture(1, 1, intArrayOf(0x7FFFFFFF))
        assertTrue(scene(Material(texture = clear, alphaMode = AlphaMode.BLEND), null).frame(9, 9).hasTranslucency)
        assertTrue(scene(material(1f).withShader { it.setColor(1f, 1f, 1f, 0.5f) }, null).frame(9, 9).hasTranslucency)
        val masked = Material(Rgba.WHITE.withAlpha(0.5f), alphaMode = AlphaMode.MASK)
        assertFalse(scene(masked, null).frame(9, 9).hasTranslucency)
    }

    @Test
    fun vertexColoursBelowOneMakeTheirTrianglesTranslucent() {
        val colors = FloatArray(24) { if (it == 15) 0.5f else 1f }
        val primitives = scene(material(1f), colors).frame(9, 9).primitives
        assertEquals(listOf(false, true), primitives.filter { it.depthForm != null }.map { it.isTranslucent })
        assertFalse(scene(Material(), colors).frame(9, 9).hasTranslucency)
    }

    @Test
    fun polygonsOnTheScreenAreTranslucentByTheirColour() {
        val triangle = doubleArrayOf(0.0, 0.0, 0.5, 4.0, 0.0, 0.5, 0.0, 3.0, 0.5)
        assertFalse(FrameBuilder(raster).polygon(Rgba.BLACK, triangle).build().hasTranslucency)
        val frame = FrameBuilder(raster).polygon(Rgba.BLACK.withAlpha(0.25f), triangle).build()
        assertTrue(frame.hasTranslucency)
        assertEquals(Rgba(0.75f, 0.75f, 0.75f).toArgb(), ListsRenderer().render(frame).argb(0, 0))
    }

    private fun material(alpha: Float) = Material(Rgba(0.9f, 0.6f, 0.3f, alpha), alphaMode = AlphaMode.BLEND)

    /** A sphere and two triangles, one in front of the other. */
    private fun scene(material: Material, colors: FloatArray?): Scene {
        val positions = floatArrayOf(-1f, -1f, 0f, 1f, -1f, 0f, 0f, 1f, 0f, -1f, -1f, 1f, 1f, -1f, 1f, 0f, 1f, 1f)
        val mesh = Mesh(positions, IntArray(6) { it }, material, null, null, colors)
        val sphere = Sphere(Vector3d(0.0, 0.0, 0.0), if (colors == null) 0.5 else Double.NaN, material)
        return Scene(listOf(sphere, mesh), background = Rgba.BLACK)
    }
}
