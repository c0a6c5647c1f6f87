package dev.lazyz.conformance.oracle

import dev.lazyz.Raster
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d

/** The ray through a sample: contract rule 2.6 in world space and double precision. */
internal class ExactRay(raster: Raster, private val camera: Camera, x: Int, y: Int) {
    private val origin: Vector3d

    /** The length for which the ray goes one unit away from the viewer. */
    private val step: Vector3d

    init {
        val across = ((2.0 * x + 1) / raster.width - 1) * raster.width / raster.height
        val up = 1 - (2.0 * y + 1) / raster.height
        when (val projection = camera.projection) {
            is Projection.Perspective -> {
                val half = Math.tan(Math.toRadians(projection.verticalFieldOfView) / 2)
                origin = Vector3d(camera.eye)
                step = camera.toWorldDirection(across * half, up * half, -1.0)
            }
            is Projection.Orthographic -> {
                val half = projection.height / 2
                origin = Vector3d(camera.eye).add(camera.toWorldDirection(across * half, up * half, 0.0))
                step = camera.toWorldDirection(0.0, 0.0, -1.0)
            }
            Projection.Screen -> error("rays are for cameras in space")
        }
    }

    fun at(distance: Double): Vector3d = Vector3d(step).mul(distance).add(origin)

    /**
     * Returns both distances at which the ray intersects [sphere], or null if it only grazes it, or intersects at the
     * near plane.
     */
    fun cut(sphere: Sphere): DoubleArray? {
        val to = Vector3d(sphere.center).sub(origin)
        val a = step.lengthSquared()
        val b = step.dot(to)
        val discriminant = b * b - a * (to.lengthSquared() - sphere.radius * sphere.radius)
        if (!(discriminant > 1e-6 * b * b)) return null
        val root = Math.sqrt(discriminant)
        val near = (b - root) / a
        return if (Math.abs(near - camera.near) < 1e-6) null else doubleArrayOf(near, (b + root) / a)
    }
}
