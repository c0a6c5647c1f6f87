package dev.lazyz.setup

import dev.lazyz.Raster
import dev.lazyz.samples
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Sphere
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rule 2.6: spheres around the eye. */
class SphereProperties {
    private val eye = Vector3d(0.0, 0.0, 0.0)

    /** Looks along -z, so that camera space is world space. */
    private fun camera(random: Random, near: Double, far: Double): Camera {
        val target = Vector3d(0.0, 0.0, -1.0)
        val up = Vector3d(0.0, 1.0, 0.0)
        return if (random.nextBoolean()) {
            Camera.perspective(eye, target, up, listOf(20.0, 60.0, 120.0)[random.nextInt(3)], near, far)
        } else {
            Camera.orthographic(eye, target, up, 0.5 + 10 * random.nextDouble(), near, far)
        }
    }

    private fun random(random: Random, reach: Double): Double = (random.nextDouble() * 2 - 1) * reach

    @Property(seed = "1995", tries = 100, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_6_insideASphereItFillsTheView(@ForAll random: Random) {
        val raster = Raster(9, 7)
        val camera = camera(random, 0.5, 100.0)
        val center = Vector3d(random(random, 1.0), random(random, 1.0), random(random, 1.0))
        val primitive = setUp(raster, camera, emptyList()).sphere(Sphere(center, 40.0))
        assertEquals(63, primitive.samples(raster).size)
        val shader = Shader { it.setColor(it.normalX, it.normalY, it.normalZ) }
        val seen = setUp(raster, camera, emptyList()).sphere(Sphere(center, 40.0, Material(shader = shader)))
        val fragment = Fragment()
        fragment.moveTo(4, 3)
        seen.shade(fragment)
        assertTrue(fragment.blue > 0.5f) { "the inside's normal points to the viewer: $fragment" }
    }
}
