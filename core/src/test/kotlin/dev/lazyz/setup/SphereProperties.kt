package dev.lazyz.setup

import dev.lazyz.Depth
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.samples
import dev.lazyz.samplesByCursor
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import java.math.BigDecimal
import java.math.MathContext
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 2.6 and 4.5: spheres, compared with rays in decimal arithmetic of 60 digits. */
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

    /**
     * The exact intersections of the ray through a sample with the sphere: both distances along the line of sight, or
     * null.
     */
    private class Rays(camera: Camera, raster: Raster, private val sphere: Sphere) {
        private val isPerspective = camera.projection is Projection.Perspective
        private val halfHeight = when (val projection = camera.projection) {
            is Projection.Perspective -> StrictMath.tan(projection.verticalFieldOfView * (StrictMath.PI / 360.0))
            is Projection.Orthographic -> projection.height / 2
            Projection.Screen -> error("no camera of this test is a screen's")
        }
        private val perPixelX =
            big(halfHeight * (raster.width.toDouble() / raster.height)) / big(raster.width.toDouble())
        private val perPixelY = big(halfHeight) / big(raster.height.toDouble())
        private val raster = raster

        private fun big(value: Double) = BigDecimal(value)

        private operator fun BigDecimal.div(other: BigDecimal): BigDecimal = divide(other, DIGITS)

        fun discriminant(x: Double, y: Double): BigDecimal {
            val (b, rest, square) = quadratic(x, y)
            return b.multiply(b).subtract(rest.multiply(square))
        }

        /** Half the linear, the constant and the quadratic coefficient of |ray(t) - c|^2 = r^2. */
        private fun quadratic(x: Double, y: Double): Triple<BigDecimal, BigDecimal, BigDecimal> {
            val px = big(2 * x - raster.width).multiply(perPixelX)
            val py = big(raster.height - 2 * y).multiply(perPixelY)
            val c = sphere.center
            val radius = big(sphere.radius)
            val one = BigDecimal.ONE
            val (cx, cy, cz) = listOf(big(c.x()), big(c.y()), big(c.z()))
            return if (isPerspective) {
                Triple(px * cx + py * cy - cz, cx * cx + cy * cy + cz * cz - radius * radius, px * px + py * py + one)
            } else {
                Triple(-cz, (px - cx) * (px - cx) + (py - cy) * (py - cy) + cz * cz - radius * radius, one)
            }
        }

        fun distances(x: Int, y: Int): Pair<BigDecimal, BigDecimal>? {
            val (b, _, square) = quadratic(x + 0.5, y + 0.5)
            val d = discriminant(x + 0.5, y + 0.5)
            if (d.signum() < 0) return null
            val root = d.sqrt(DIGITS)
            return Pair((b - root) / square, (b + root) / square)
        }

        private companion object {
            val DIGITS = MathContext(60)
        }
    }

    private fun random(random: Random, reach: Double): Double = (random.nextDouble() * 2 - 1) * reach

    private fun sphere(random: Random): Sphere {
        val radius = listOf(1e-6, 0.01, 0.3, 1.0, 3.0, 50.0, 1e6)[random.nextInt(7)] * (0.5 + random.nextDouble())
        val z = when (random.nextInt(4)) {
            0 -> random(random, 5.0)
            1 -> -radius - random.nextDouble() * 10
            2 -> -radius - 1.0
            else -> -random.nextDouble() * 100
        }
        val aside = if (random.nextBoolean()) 0.3 * Math.abs(z) else radius + 2
        val center = Vector3d(random(random, aside), random(random, aside), z)
        return Sphere(center, radius, Material(sides = if (random.nextInt(5) == 0) Sides.FRONT else Sides.BOTH))
    }

    @Property(seed = "1995", tries = 200, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_6_raysDecideCoverageAndDepth(@ForAll random: Random) {
        val (width, height) = listOf(Pair(1, 1), Pair(24, 16), Pair(7, 30), Pair(1, 40))[random.nextInt(4)]
        val raster = Raster(width, height)
        val near = if (random.nextBoolean()) 1.0 else 0.01
        val camera = camera(random, near, near + 1 + random.nextInt(100))
        val sphere = sphere(random)
        val primitive = SetUp(raster, camera, emptyList()).sphere(sphere)
        val covered = primitive.samples(raster)
        assertEquals(covered, primitive.samplesByCursor(raster, 0))
        val rays = Rays(camera, raster, sphere)
        for (y in 0 until height) {
            for (x in 0 until width) {
                val expected = expectedDistance(rays, sphere, camera, x, y)
                val problem = when {
                    (expected != null) != covered[x, y] -> "it is covered: ${covered[x, y]}"
                    expected != null -> depthProblem(primitive, camera, x, y, expected)
                    else -> null
                }
                // Doubts take long to find, so that only answers that seem wrong are examined
                assertTrue(problem == null || isDoubtful(rays, sphere, camera, x, y)) {
                    "sample $x, $y of $sphere from $camera: $problem"
                }
            }
        }
    }

    private fun expectedDistance(rays: Rays, sphere: Sphere, camera: Camera, x: Int, y: Int): BigDecimal? {
        val (first, second) = rays.distances(x, y) ?: return null
        val near = BigDecimal(camera.near)
        val far = BigDecimal(camera.far)
        if (first >= near) return first.takeIf { it <= far }
        if (sphere.material.sides == Sides.FRONT) return null
        return second.takeIf { it >= near && it <= far }
    }

    /** Whether the outline or the edge of a cut is so close that double precision can give a different answer. */
    private fun isDoubtful(rays: Rays, sphere: Sphere, camera: Camera, x: Int, y: Int): Boolean {
        val size = sphere.center.length() + sphere.radius
        val signs = listOf(0.4999, 0.5, 0.5001).flatMap { dx ->
            listOf(0.4999, 0.5, 0.5001).map { dy -> rays.discriminant(x + dx, y + dy).signum() }
        }
        if (signs.distinct().size > 1) return true
        val (first, second) = rays.distances(x, y) ?: return false
        val tolerance = BigDecimal(1e-9 * maxOf(1.0, size))
        return listOf(first, second).any { distance ->
            listOf(camera.near, camera.far).any { distance.subtract(BigDecimal(it)).abs() < tolerance }
        }
    }

    /** Says what is wrong with the depth of a sample; null if nothing is. */
    private fun depthProblem(primitive: Primitive, camera: Camera, x: Int, y: Int, distance: BigDecimal): String? {
        val near = BigDecimal(camera.near)
        val far = BigDecimal(camera.far)
        val range = far - near
        val unit = if (camera.projection is Projection.Perspective) {
            far.multiply(distance - near).divide(range.multiply(distance), MathContext(40))
        } else {
            (distance - near).divide(range, MathContext(40))
        }
        val exact = BigDecimal(Depth.NEAR).add(unit.multiply(BigDecimal(Depth.FAR - Depth.NEAR)))
        val depth = primitive.depth(x, y)
        val error = exact.subtract(BigDecimal(depth)).abs().toDouble()
        return when {
            error >= 1.0 -> "depth $depth is off by $error"
            depth !in primitive.leastDepth..primitive.greatestDepth -> "depth $depth is outside the bounds"
            else -> null
        }
    }

    @Property(seed = "1995", tries = 100, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_6_insideASphereItFillsTheView(@ForAll random: Random) {
        val raster = Raster(9, 7)
        val camera = camera(random, 0.5, 100.0)
        val center = Vector3d(random(random, 1.0), random(random, 1.0), random(random, 1.0))
        val primitive = SetUp(raster, camera, emptyList()).sphere(Sphere(center, 40.0))
        assertEquals(63, primitive.samples(raster).size)
        val shader = Shader { it.setColor(it.normalX, it.normalY, it.normalZ) }
        val seen = SetUp(raster, camera, emptyList()).sphere(Sphere(center, 40.0, Material(shader = shader)))
        val fragment = Fragment()
        fragment.moveTo(4, 3)
        seen.shade(fragment)
        assertTrue(fragment.blue > 0.5f) { "the inside's normal points to the viewer: $fragment" }
    }
}
