package dev.lazyz.world.camera

import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Scenes in screen space, [Camera.screen]. */
class ScreenCameraTest {
    private val place = Shader { it.setColor(it.worldX / 16, it.worldY / 16, it.worldZ, 0.5f) }

    @Property(seed = "1995", tries = 300)
    fun rule_1_3_polygonsAreThoseOfTheFrameBuilder(@ForAll seed: Long) {
        // Half of the positions are halfway between grid lines, where the last bit matters; some are at the limits
        val random = Random(seed)
        val contours = List(1 + random.nextInt(2)) {
            DoubleArray(3 * (1 + random.nextInt(6))) { i ->
                val fraction = if (random.nextInt(8) == 0) random.nextInt(2).toDouble() else random.nextDouble()
                when {
                    i % 3 == 2 -> fraction
                    random.nextInt(9) == 0 -> (2 * fraction - 1) * 524288
                    else -> random.nextInt(20 * 512) / 512.0
                }
            }
        }
        val rule = FillRule.entries[random.nextInt(2)]
        val convention = DepthConvention.entries[random.nextInt(2)]
        val raster = Raster(1 + random.nextInt(17), 1 + random.nextInt(17), Rgba.BLACK, convention)
        val vertices = contours.map { c -> (c.indices step 3).map { Vertex(c[it], c[it + 1], c[it + 2]) } }
        val polygon = Polygon(vertices, Material(shader = place), rule)
        val expected = FrameBuilder(raster).polygon(place, rule, *contours.toTypedArray()).build()
        assertSame(expected, Scene(listOf(polygon), viewpoint = Camera.screen()).frame(raster))
    }

    private fun assertSame(expected: Frame, actual: Frame) {
        val (a, b) = listOf(expected, actual).map { ZBufferRenderer().render(it) }
        assertArrayEquals(a.argb, b.argb)
        assertArrayEquals(a.depth, b.depth)
        assertArrayEquals(a.primitive, b.primitive)
    }

    private fun square(x: Double, side: Double, near: Double, far: Double) = Polygon(
        listOf(
            listOf(
                Vertex(x, 0.0, near), Vertex(x, side, near), Vertex(x + side, side, far), Vertex(x + side, 0.0, far),
            ),
        ),
        Material(shading = Shading.CONSTANT, sides = Sides.FRONT),
    )

    private fun picture(surface: Surface, camera: Camera = Camera.screen()): Image =
        ZBufferRenderer().render(Scene(listOf(surface), viewpoint = camera).frame(8, 8))

    @Test
    fun rule_9_1_whatIsBeforeNearOrBehindFarIsClipped() {
        val image = picture(square(0.0, 8.0, -0.5, 1.5))
        assertEquals(listOf(-1, -1, 0, 0, 0, 0, -1, -1), image.primitive.take(8))
        assertEquals(Depth.ofUnit(0.125), image.depth(2, 0))
        assertEquals(64, picture(square(0.0, 8.0, -0.5, 1.5), Camera.screen(-1.0, 2.0)).visible)
        assertEquals(0, picture(square(0.0, 8.0, -2.0, -1.0)).visible)
    }

    @Test
    fun frontIsWhereVerticesRunCounterClockwiseOnTheScreen() {
        assertEquals(64, picture(square(0.0, 8.0, 0.5, 0.5)).visible)
        val back = square(0.0, 8.0, 0.5, 0.5).run { Polygon(contours.map { it.reversed() }, material) }
        assertEquals(0, picture(back).visible)
    }

    @Test
    fun spheresAreThoseOfTheOrthographicCameraThatSeesTheRaster() {
        val raster = Raster(16, 16)
        val corner = Vector3d(8.0, 8.0, 0.0)
        val flat = Camera.orthographic(corner, Vector3d(8.0, 8.0, 1.0), Vector3d(0.0, -1.0, 0.0), 16.0, -4.0, 32.0)
        for (center in listOf(Vector3d(8.0, 7.0, 10.0), Vector3d(2.0, 13.5, -2.0))) {
            val scene = Scene(listOf(Sphere(center, 5.0)))
            val expected = scene.withViewpoint(flat).frame(raster)
            assertSame(expected, scene.withViewpoint(Camera.screen(-4.0, 32.0)).frame(raster))
            assertTrue(ZBufferRenderer().render(expected).visible > 20)
        }
    }

    @Test
    fun wrongPlanesAreRefusedAndThereIsNoProjectionMatrix() {
        assertThrows(IllegalArgumentException::class.java) { Camera.screen(1.0, 1.0) }
        assertThrows(IllegalArgumentException::class.java) { Camera.screen(0.0, Double.NaN) }
        assertThrows(IllegalStateException::class.java) { Camera.screen().projectionMatrix(1.0) }
    }
}
