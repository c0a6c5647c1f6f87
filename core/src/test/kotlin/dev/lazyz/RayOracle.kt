package dev.lazyz

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import org.joml.Vector3d
import org.joml.Vector4d

/**
 * Determines with rays through the eye, without clipping, whether a convex flat polygon is visible at a sample, between
 * the planes of a perspective camera.
 */
class RayOracle(camera: Camera, private val raster: Raster, corners: List<Vector3d>) {
    private val near = camera.near
    private val far = camera.far
    private val angle = (camera.projection as Projection.Perspective).verticalFieldOfView
    private val tangent = StrictMath.tan(angle * StrictMath.PI / 360)

    /** Corners in camera space. */
    private val points = corners.map {
        val p = camera.viewMatrix().transform(Vector4d(it.x, it.y, it.z, 1.0))
        Vector3d(p.x, p.y, p.z)
    }

    /** Half-spaces of rays (x, y, -1): one for each edge, and one for each of the two planes. */
    private val sides: List<Vector3d>

    init {
        val (a, b, c) = points
        val normal = Vector3d(b).sub(a).cross(Vector3d(c).sub(a))
        val height = normal.dot(a)
        val sign = Math.signum(height)
        val edges = points.indices.map { Vector3d(points[it]).cross(points[(it + 1) % points.size]).mul(sign) }

        // The ray meets the plane at t = height / (normal . ray): near <= t <= far, for a positive height
        val total = Vector3d(normal).mul(sign)
        val lengthened = { limit: Double, direction: Double ->
            Vector3d(total).mul(-limit * direction).sub(0.0, 0.0, Math.abs(height) * direction)
        }
        sides = edges + lengthened(near, 1.0) + lengthened(far, -1.0)
    }

    /** Whether the sample is covered; null if it is within 1/64 pixel of the border. */
    fun verdict(x: Int, y: Int): Boolean? {
        var isInside = true
        for (side in sides) {
            var inside = 0
            for (corner in 0 until 4) {
                val px = x + 0.5 + if (corner and 1 == 0) -MARGIN else MARGIN
                val py = y + 0.5 + if (corner and 2 == 0) -MARGIN else MARGIN
                val rayX = (2 * px / raster.width - 1) * tangent * raster.width / raster.height
                val rayY = (1 - 2 * py / raster.height) * tangent
                if (side.x * rayX + side.y * rayY - side.z > 0) inside++
            }
            if (inside == 0) return false
            if (inside < 4) isInside = false
        }
        return if (isInside) true else null
    }

    private companion object {
        const val MARGIN = 1.0 / 64
    }
}
