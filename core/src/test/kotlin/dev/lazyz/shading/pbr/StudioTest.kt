package dev.lazyz.shading.pbr

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 6.10: the studio. */
class StudioTest {
    private fun radiance(direction: Vector3d, alpha: Double): Double {
        val out = FloatArray(3)
        val roughness = Math.sqrt(alpha).toFloat()
        Studio.radiance(direction.x.toFloat(), direction.y.toFloat(), direction.z.toFloat(), roughness, out, 0)
        return out[1].toDouble()
    }

    private fun irradiance(direction: Vector3d): Double {
        val out = FloatArray(3)
        Studio.irradiance(direction.x.toFloat(), direction.y.toFloat(), direction.z.toFloat(), out, 0)
        return out[1].toDouble()
    }

    /** Directions that divide the sphere evenly (Fibonacci). */
    private val sphere = List(20_000) {
        val y = 1.0 - (2.0 * it + 1.0) / 20_000
        val angle = it * Math.PI * (3.0 - Math.sqrt(5.0))
        val level = Math.sqrt(1.0 - y * y)
        Vector3d(level * Math.cos(angle), y, level * Math.sin(angle))
    }

    private val directions = sphere.filterIndexed { i, _ -> i % 701 == 0 }

    @Test
    fun rule_6_10_irradianceIsTheMeanUnderTheCosine() {
        for (normal in directions) {
            val mean = sphere.sumOf { maxOf(it.dot(normal), 0.0) * radiance(it, 0.0) } * 4 / sphere.size
            assertEquals(mean, irradiance(normal), 0.06 * mean + 0.03, "$normal")
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_10_blurredLightIsTheMeanUnderTheLobe() {
        // The lobe of Karis: each direction of light that microfacets reflect, with the weight of its cosine
        for (alpha in listOf(0.04, 0.09, 0.25, 0.5, 0.8, 1.0)) {
            val squares = directions.map { axis ->
                var sum = 0.0
                var weights = 0.0
                for (light in sphere) {
                    val cosine = light.dot(axis)
                    if (cosine <= 0.0) continue
                    val cosineH = Math.sqrt((1.0 + cosine) / 2.0)
                    val weight = cosine * Appendix.distribution(cosineH, alpha)
                    sum += weight * radiance(light, 0.0)
                    weights += weight
                }
                val difference = radiance(axis, alpha) - sum / weights
                assertTrue(Math.abs(difference) < 0.5) { "$alpha, $axis: $difference" }
                difference * difference
            }
            assertTrue(Math.sqrt(squares.average()) < 0.13) { "$alpha: ${Math.sqrt(squares.average())}" }
        }
    }

    @Test
    fun rule_6_10_theFrontIsOnTheSideOfTheCameraAndTheStudioIsUpright() {
        val up = Vector3d(0.0, 1.0, 0.0)
        fun view(eye: Vector3d, up: Vector3d = Vector3d(0.0, 1.0, 0.0)) =
            EnvironmentView.of(Environment.studio(), Camera.perspective(eye, Vector3d(), up, 45.0, 1.0, 10.0))!!

        fun seen(view: EnvironmentView, direction: Vector3d) = FloatArray(PhysicalSurface.SIZE).also {
            view.radiance(direction.x.toFloat(), direction.y.toFloat(), direction.z.toFloat(), 0f, it)
        }
        val front = view(Vector3d(0.0, 0.0, 5.0))
        val right = view(Vector3d(5.0, 3.0, 0.0))
        val above = view(Vector3d(0.0, 5.0, 0.0), Vector3d(0.0, 0.0, -1.0))
        for (direction in directions) {
            val turned = Vector3d(direction.z, direction.y, -direction.x)
            assertArrayEquals(seen(front, direction), seen(right, turned), 1e-3f)
            assertArrayEquals(seen(front, direction), seen(above, direction), 1e-3f)
        }
        val first = PhysicalSurface.RADIANCE
        assertTrue(seen(front, up)[first] > seen(front, Vector3d(0.0, -1.0, 0.0))[first])
    }
}
