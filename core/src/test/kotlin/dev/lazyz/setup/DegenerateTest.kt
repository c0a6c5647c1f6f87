package dev.lazyz.setup

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.geometry.FillRule
import dev.lazyz.samples
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rules 9.4 to 9.6: degenerate input, for which little or nothing is drawn. */
class DegenerateTest {
    private val raster = Raster(8, 8)
    private val shader = Shader { it.setColor(1f, 0f, 0f) }
    private val setUp = setUp(raster, SampleScenes.camera, emptyList())

    private fun polygon(vararg contours: DoubleArray): Primitive =
        FrameBuilder(raster).polygon(shader, FillRule.NON_ZERO, *contours).build().primitives.single()

    private fun assertEmpty(primitive: Primitive) {
        assertEquals(0, primitive.samples(raster).size) { primitive.toString() }
        val counters = ZBufferRenderer().render(Frame(raster, listOf(primitive))).counters
        assertEquals(1, counters.primitives)
        assertEquals(0, counters.fragments)
    }

    @Test
    fun rule_9_4_whatHasNoAreaCoversNothing() {
        assertEmpty(polygon())
        assertEmpty(polygon(doubleArrayOf()))
        assertEmpty(polygon(doubleArrayOf(1.5, 1.5, 0.5)))
        assertEmpty(polygon(doubleArrayOf(1.5, 1.5, 0.5, 6.5, 6.5, 0.5)))
        assertEmpty(polygon(doubleArrayOf(1.5, 1.5, 0.5, 6.5, 6.5, 0.5, 3.5, 3.5, 0.5)))
        assertEmpty(polygon(doubleArrayOf(1.5, 2.5, 0.5, 6.5, 2.5, 0.5, 3.5, 2.5, 0.5)))
        assertEmpty(polygon(doubleArrayOf(2.5, 1.5, 0.5, 2.5, 6.5, 0.5, 2.5, 3.5, 0.1, 2.5, 0.5, 0.2)))
        assertEmpty(polygon(DoubleArray(30) { 3.5 }))
    }

    @Test
    fun rule_9_4_whatMissesAllSamplesCoversNothing() {
        assertEmpty(polygon(doubleArrayOf(1.6, 1.6, 0.5, 2.4, 1.6, 0.5, 2.0, 2.4, 0.5)))
        assertEmpty(polygon(doubleArrayOf(-5.0, -5.0, 0.5, -1.0, -5.0, 0.5, -1.0, -1.0, 0.5)))
        assertEmpty(polygon(doubleArrayOf(9.0, 1.0, 0.5, 15.0, 1.0, 0.5, 9.0, 7.0, 0.5)))
    }

    @Test
    fun rule_9_4_degenerateFacesKeepTheirIndex() {
        val mesh = Mesh(
            floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f, 9f, 9f, 90f),
            intArrayOf(0, 0, 0, 0, 1, 1, 3, 3, 3, 0, 1, 2),
        )
        val image = ZBufferRenderer().render(Scene(listOf(mesh), viewpoint = SampleScenes.camera).frame(16, 16))
        assertEquals(4, image.counters.primitives)
        assertEquals(setOf(-1, 3), image.primitive.toSet())
    }

    @Test
    fun rule_9_5_numbersThatAreNoneCoverNothing() {
        for (bad in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) {
            for (place in 0 until 9) {
                val contour = doubleArrayOf(1.0, 1.0, 0.5, 7.0, 1.0, 0.5, 1.0, 7.0, 0.5)
                contour[place] = bad
                assertEmpty(polygon(contour))
                assertEmpty(polygon(doubleArrayOf(0.0, 0.0, 0.5, 8.0, 0.0, 0.5, 0.0, 8.0, 0.5), contour))
                val mesh = Mesh(FloatArray(9) { contour[it].toFloat() }, intArrayOf(0, 1, 2))
                assertEmpty(setUp.mesh(mesh).single())
                val vertices = List(3) { Vertex(contour[3 * it], contour[3 * it + 1], contour[3 * it + 2]) }
                assertEmpty(setUp.polygon(Polygon(listOf(vertices))))
            }
            for (place in 0 until 3) {
                val center = Vector3d().setComponent(place, bad)
                assertEmpty(setUp.sphere(Sphere(center, 1.0)))
            }
            if (bad > 0 || bad.isNaN()) assertEmpty(setUp.sphere(Sphere(Vector3d(), bad)))
        }
    }

    @Test
    fun rule_9_5_numbersThatAreNoneInAttributesDoNoHarm() {
        val nan = FloatArray(9) { Float.NaN }
        for (shading in Shading.entries) {
            val material = Material(texture = SampleScenes.checks, shading = shading, specular = Rgba.WHITE)
            val positions = floatArrayOf(-1f, -1f, 0f, 1f, -1f, 0f, 0f, 1f, 0f)
            val mesh = Mesh(positions, intArrayOf(0, 1, 2), material, nan, nan.copyOf(6), nan + nan.copyOf(3))
            val image = ZBufferRenderer().render(Scene(listOf(mesh), viewpoint = SampleScenes.camera).frame(8, 8))
            assertTrue(image.visible > 0)
        }
    }

    @Test
    fun rule_9_5_giantsNeitherThrowNorHang() {
        val random = Random(5)
        for (scale in listOf(1e-300, 1e-45, 1e-30, 1e9, 1e30, 1e150, 1e200, 1e300, Double.MAX_VALUE)) {
            repeat(40) {
                val vertices = List(3 + random.nextInt(4)) {
                    val (x, y, z) = List(3) {
                        if (random.nextInt(3) == 0) {
                            random.nextDouble()
                        } else {
                            (random.nextDouble() * 2 - 1) * scale
                        }
                    }
                    Vertex(x, y, z)
                }
                for (camera in listOf(SampleScenes.camera, orthographic())) {
                    val surfaces =
                        listOf(Polygon(listOf(vertices), SHINY), Sphere(Vector3d(0.0, 0.0, -scale), scale, SHINY))
                    ZBufferRenderer().render(Scene(surfaces, viewpoint = camera).frame(raster))
                }
            }
        }
    }

    @Test
    fun rule_9_5_giantMeshesNeitherThrowNorHang() {
        val random = Random(6)
        for (scale in listOf(Float.MIN_VALUE, 1e-38f, 1e9f, 1e20f, 1e30f, Float.MAX_VALUE)) {
            repeat(40) {
                val positions = FloatArray(9) {
                    if (random.nextInt(3) == 0) random.nextFloat() else (random.nextFloat() * 2 - 1) * scale
                }
                val mesh = Mesh(positions, intArrayOf(0, 1, 2), SHINY)
                for (camera in listOf(SampleScenes.camera, orthographic())) {
                    val scene = Scene(listOf(mesh, mesh.withSmoothNormals()), viewpoint = camera)
                    ZBufferRenderer().render(scene.frame(raster))
                }
                mesh.transformed(Matrix4d().scaling(1e30))
            }
        }
    }

    @Test
    fun rule_9_5_fittedCamerasExistForGiantScenes() {
        val random = Random(7)
        for (scale in listOf(Float.MIN_VALUE, 1e-38f, 1e-20f, 1f, 1e9f, 1e20f, 1e30f, Float.MAX_VALUE)) {
            for (offset in listOf(0f, 1e-30f, 1f, 1e9f, 1e20f, 1e30f)) {
                val positions = FloatArray(9) { offset + (random.nextFloat() * 2 - 1) * scale }
                val mesh = Mesh(positions, intArrayOf(0, 1, 2), SHINY)
                for (fit in Fit.entries) {
                    ZBufferRenderer().render(Scene(listOf(mesh), viewpoint = Camera.fit(kind = fit)).frame(raster))
                }
            }
        }
    }

    private fun orthographic(): Camera =
        Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, -10.0, 20.0)

    private companion object {
        val SHINY = Material(specular = Rgba.WHITE)
    }
}
