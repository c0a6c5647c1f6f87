package dev.lazyz.world.camera

import dev.lazyz.Raster
import dev.lazyz.SampleSet
import dev.lazyz.samples
import dev.lazyz.setup.setUp
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class CameraTest {
    private val random = Random(9)
    private val up = Vector3d(0.0, 1.0, 0.0)

    private fun vector(reach: Double) = Vector3d(
        (random.nextDouble() * 2 - 1) * reach, (random.nextDouble() * 2 - 1) * reach,
        (random.nextDouble() * 2 - 1) * reach,
    )

    private fun assertClose(expected: Matrix4d, actual: Matrix4d) {
        for (column in 0 until 4) {
            for (row in 0 until 4) {
                val e = expected.get(column, row)
                assertEquals(e, actual.get(column, row), 1e-12 * maxOf(1.0, Math.abs(e))) { "$expected and $actual" }
            }
        }
    }

    @Test
    fun theViewMatrixIsTheUsualOne() {
        repeat(200) {
            val eye = vector(10.0)
            val target = vector(10.0)
            val someUp = vector(1.0)
            val camera = Camera.perspective(eye, target, someUp, 45.0, 1.0, 10.0)
            assertClose(Matrix4d().lookAt(eye, target, someUp), camera.viewMatrix())
        }
    }

    private fun places(camera: Camera) = listOf(camera.eye, camera.target, camera.up)

    /** Everything else stays, to the bit: also axes that could not be computed from rounded positions again. */
    @Test
    fun otherPlanesChangeNothingElse() {
        val cameras = listOf(
            Camera.perspective(Vector3d(1.0, 2.0, 3.0), Vector3d(), Vector3d(0.1, 1.0, 0.0), 45.0, 1.0, 10.0),
            Camera.orthographic(Vector3d(1.0, 2.0, 3.0), Vector3d(), up, 4.0, -1.0, 10.0),
            Camera.perspective(Vector3d(0.1, 1.0, 7.0), Vector3d(1.1, 2.5, 3.0), up, 45.0, 1.0, 10.0)
                .relativeTo(Vector3d(1e16, 0.0, 0.0)),
        )
        for (camera in cameras) {
            val changed = camera.withPlanes(0.5, 77.0)
            assertEquals(0.5, changed.near)
            assertEquals(77.0, changed.far)
            assertEquals(camera.projection, changed.projection)
            assertEquals(places(camera), places(changed))
            assertEquals(camera.viewMatrix(), changed.viewMatrix())
            assertThrows(IllegalArgumentException::class.java) { camera.withPlanes(2.0, 2.0) }
        }
        assertThrows(IllegalArgumentException::class.java) { cameras[0].withPlanes(0.0, 1.0) }
        assertEquals(-5.0, cameras[1].withPlanes(-5.0, 1.0).near)
    }

    @Test
    fun theProjectionMatricesAreTheUsualOnes() {
        repeat(200) {
            val angle = 1 + random.nextDouble() * 170
            val aspect = 0.1 + random.nextDouble() * 5
            val near = 0.01 + random.nextDouble()
            val far = near + random.nextDouble() * 100 + 0.1
            val perspective = Camera.perspective(Vector3d(), Vector3d(1.0, 0.0, 0.0), up, angle, near, far)
            val usual = Matrix4d().perspective(Math.toRadians(angle), aspect, near, far)
            assertClose(usual, perspective.projectionMatrix(aspect))
            val height = 0.1 + random.nextDouble() * 10
            val flat = Camera.orthographic(Vector3d(), Vector3d(1.0, 0.0, 0.0), up, height, near - 5, far)
            val halfWidth = height / 2 * aspect
            val expected = Matrix4d().ortho(-halfWidth, halfWidth, -height / 2, height / 2, near - 5, far)
            assertClose(expected, flat.projectionMatrix(aspect))
        }
    }

    @Test
    fun lookingAlongUpChoosesAnAxis() {
        for (direction in listOf(Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, -3.0, 0.0))) {
            val camera = Camera.perspective(Vector3d(), direction, up, 45.0, 1.0, 10.0)
            assertEquals(1.0, camera.viewMatrix().determinant(), 1e-12)
        }
    }

    /** Each zoom that is accepted gives a camera. */
    @Test
    fun zoomsHaveARange() {
        val scene = Scene(listOf(Sphere(Vector3d(), 1.0)))
        for (kind in Fit.entries) {
            for (zoom in listOf(1e-9, 1e9)) {
                for (angle in listOf(1.0, Camera.MAX_FITTED_FIELD_OF_VIEW)) {
                    val camera = Camera.fit(zoom = zoom, kind = kind, fieldOfView = angle).camera(scene, 1.0)
                    assertTrue(camera.projectionMatrix(1.0).isFinite) { "$camera" }
                }
            }
            for (zoom in listOf(1e-17, 0.99e-9, 1.01e9, 1e308, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
                val fit = Camera.fit(kind = kind)
                val refused = assertThrows(IllegalArgumentException::class.java) { fit.withZoom(zoom) }
                assertEquals("zoom must be in 1e-9..1e9: $zoom", refused.message)
            }
        }
    }

    @Test
    fun rule_1_1_theCentreIsTheMiddleAndYGrowsDownward() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), up, 4.0, 1.0, 9.0)
        val mesh = Mesh(floatArrayOf(-2f, 2f, 0f, -2f, 1f, 0f, -1f, 2f, 0f), intArrayOf(0, 1, 2))
        val covered = setUp(Raster(4, 4), camera, emptyList()).mesh(mesh).single().samples(Raster(4, 4))
        assertEquals(SampleSet.where(4, 4) { x, y -> x == 0 && y == 0 && covered[0, 0] }, covered)
        val wide = Mesh(floatArrayOf(-2f, 2f, 0f, -2f, 0.9f, 0f, -0.9f, 2f, 0f), intArrayOf(0, 1, 2))
        val first = setUp(Raster(4, 4), camera, emptyList()).mesh(wide).single().samples(Raster(4, 4))
        assertEquals(SampleSet.where(4, 4) { x, y -> x == 0 && y == 0 }, first)
    }

    @Test
    fun wrongNumbersAreRefused() {
        val eye = Vector3d()
        val target = Vector3d(0.0, 0.0, -1.0)
        fun refused(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block)
        refused { Camera.perspective(eye, eye, up, 45.0, 1.0, 2.0) }
        refused { Camera.perspective(eye, target, Vector3d(), 45.0, 1.0, 2.0) }
        refused { Camera.perspective(eye, target, up, 0.0, 1.0, 2.0) }
        refused { Camera.perspective(eye, target, up, 180.0, 1.0, 2.0) }
        refused { Camera.perspective(eye, target, up, Double.NaN, 1.0, 2.0) }
        refused { Camera.perspective(eye, target, up, 45.0, 0.0, 2.0) }
        refused { Camera.perspective(eye, target, up, 45.0, 2.0, 2.0) }
        refused { Camera.perspective(eye, target, up, 45.0, 1.0, Double.POSITIVE_INFINITY) }
        refused { Camera.perspective(Vector3d(Double.NaN), target, up, 45.0, 1.0, 2.0) }
        refused { Camera.orthographic(eye, target, up, 0.0, 1.0, 2.0) }
        refused { Camera.orthographic(eye, target, up, 1.0, 3.0, 2.0) }
        refused { Camera.fit(elevation = 91.0) }
        refused { Camera.fit(azimuth = Double.NaN) }
        refused { Camera.fit(zoom = 0.0) }
        for (margin in listOf(-1.0, 50.0, Double.NaN)) refused { Camera.fit(margin = margin) }
        for (angle in listOf(0.0, 140.1, Double.NaN)) refused { Camera.fit(fieldOfView = angle) }
    }
}
