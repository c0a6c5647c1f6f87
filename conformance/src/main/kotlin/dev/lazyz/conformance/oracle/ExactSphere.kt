package dev.lazyz.conformance.oracle

import dev.lazyz.Depth
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Sphere
import java.math.BigDecimal
import java.math.MathContext

/**
 * A sphere seen through a camera with the coverage and depth of contract rules 2.6 and 4.5 in 40 decimal digits.
 *
 * The rules are defined in double precision. A sample whose discriminant, or whose distance from a plane, is too close
 * to zero for double precision is therefore [Coverage.OPEN]; all others have one correct answer. Implements the rules
 * independently of set-up, except for the camera's matrices. Immutable and thread safe.
 *
 * @throws IllegalArgumentException if the sphere's material has a mask
 */
public class ExactSphere(raster: Raster, private val camera: Camera, private val sphere: Sphere) : ExactSurface {
    private val isPerspective = camera.projection is Projection.Perspective
    private val isMirrored = raster.convention == DepthConvention.LARGER_IS_NEARER
    private val near = big(camera.near)
    private val far = big(camera.far)

    /** Whether the sphere covers anything according to rules 9.4 and 9.5. */
    private val isSphere = sphere.radius > 0.0 && sphere.radius.isFinite() && sphere.center.isFinite
    private val radius = if (isSphere) big(sphere.radius) else BigDecimal.ZERO
    private val center = if (isSphere) center() else emptyList()
    private val halfHeight = one / big(camera.projectionMatrix(1.0).m11())
    private val rows = raster.height
    private val columns = raster.width

    init {
        require(sphere.material.alphaMode != AlphaMode.MASK) { "the sphere must not have a mask: $sphere" }
    }

    override fun coverage(x: Int, y: Int): Coverage {
        if (!isSphere) return Coverage.UNCOVERED
        val ray = Ray(x, y)
        return when {
            ray.discriminant.abs() <= ray.uncertainty -> Coverage.OPEN
            ray.discriminant.signum() < 0 -> Coverage.UNCOVERED
            ray.isOpen(near, ray.first) || ray.isOpen(far, ray.first) -> Coverage.OPEN
            ray.first >= near -> coveredIf(ray.first <= far)
            sphere.material.sides == Sides.FRONT -> Coverage.UNCOVERED
            ray.isOpen(near, ray.second) || ray.isOpen(far, ray.second) -> Coverage.OPEN
            else -> coveredIf(ray.second >= near && ray.second <= far)
        }
    }

    override fun depthError(x: Int, y: Int, depth: Int): Double {
        val ray = Ray(x, y)
        val t = if (ray.first >= near) ray.first else ray.second
        val along = (t - near) / (far - near)
        val unit = if (isPerspective) along * far / t else along
        val exact = big(Depth.NEAR.toDouble()) +
            unit.max(BigDecimal.ZERO).min(one) * big((Depth.FAR - Depth.NEAR).toDouble())
        val own = if (isMirrored) Int.MAX_VALUE - depth else depth
        return (exact - big(own.toDouble())).abs().toDouble()
    }

    /** The centre in camera space. */
    private fun center(): List<BigDecimal> {
        val m = camera.viewMatrix()
        val x = big(sphere.center.x()) - big(camera.eye.x())
        val y = big(sphere.center.y()) - big(camera.eye.y())
        val z = big(sphere.center.z()) - big(camera.eye.z())
        return listOf(
            big(m.m00()) * x + big(m.m10()) * y + big(m.m20()) * z,
            big(m.m01()) * x + big(m.m11()) * y + big(m.m21()) * z,
            big(m.m02()) * x + big(m.m12()) * y + big(m.m22()) * z,
        )
    }

    /** The ray through a sample, and the distances along the viewing direction at which it intersects the sphere. */
    private inner class Ray(x: Int, y: Int) {
        private val px = (big(2.0 * x + 1.0) / big(columns.toDouble()) - one) * halfHeight *
            big(columns.toDouble()) / big(rows.toDouble())
        private val py = (one - big(2.0 * y + 1.0) / big(rows.toDouble())) * halfHeight
        private val square = if (isPerspective) px * px + py * py + one else one
        private val cz = center[2]
        private val toCenter = center.fold(BigDecimal.ZERO) { sum, it -> sum + it * it }

        /** A quarter of the quadratic's discriminant; negative for a miss. */
        val discriminant: BigDecimal = if (isPerspective) {
            val (cx, cy) = center
            val a = py * cz + cy
            val b = px * cz + cx
            val c = px * cy - py * cx
            square * radius * radius - (a * a + b * b + c * c)
        } else {
            radius * radius - (px - center[0]) * (px - center[0]) - (py - center[1]) * (py - center[1])
        }

        /** Upper bound of the error of double precision, with a margin. */
        val uncertainty: BigDecimal = (square + px * px + py * py) * (radius * radius + toCenter + one) * ROOM

        private val half = discriminant.max(BigDecimal.ZERO).sqrt(digits)
        private val middle = if (isPerspective) (px * center[0] + py * center[1] - cz) else -cz
        val first: BigDecimal = (middle - half) / square
        val second: BigDecimal = (middle + half) / square

        /** Returns whether double precision may put [t] on the other side of [plane]. */
        fun isOpen(plane: BigDecimal, t: BigDecimal): Boolean =
            (t - plane).abs() * square <= uncertainty / half.max(ROOM) + (toCenter + one) * ROOM
    }

    override fun toString(): String = "ExactSphere($sphere, $camera)"

    private companion object {
        val digits = MathContext(40)
        val one: BigDecimal = BigDecimal.ONE
        val ROOM: BigDecimal = BigDecimal("1e-13")

        fun coveredIf(isCovered: Boolean) = if (isCovered) Coverage.COVERED else Coverage.UNCOVERED

        fun big(value: Double) = BigDecimal(value, digits)

        operator fun BigDecimal.times(other: BigDecimal): BigDecimal = multiply(other, digits)

        operator fun BigDecimal.div(other: BigDecimal): BigDecimal = divide(other, digits)
    }
}
