package dev.lazyz.world

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import org.joml.Vector3d

/**
 * Where a scene is, along the axes of a camera: x to the right, y up, z toward the viewer. Coordinates are relative to
 * the centre of the scene's box. An empty scene counts as a box of size 1.
 *
 * @param axes a camera, of which only the directions are used
 */
internal class SceneExtent(private val scene: Scene, axes: Camera) {
    private val box = scene.bounds ?: UNIT_BOX
    private val center = box.center

    val right = axes.right
    val upward = axes.upward
    private val backward = axes.backward

    val left = -most(right, -1.0)
    val bottom = -most(upward, -1.0)
    val back = -most(backward, -1.0)
    val front = most(backward, 1.0)
    val width = most(right, 1.0) - left
    val height = most(upward, 1.0) - bottom
    val depth = front - back

    /** Distance between the near or far plane and the scene. */
    val pad: Double = pad(maxOf(width, height, depth) / 2)

    /** Returns the point of world space with these coordinates. */
    fun point(x: Double, y: Double, z: Double): Vector3d = Vector3d(
        center.x + right.x * x + upward.x * y + backward.x * z,
        center.y + right.y * x + upward.y * y + backward.y * z,
        center.z + right.z * x + upward.z * y + backward.z * z,
    )

    /**
     * Returns the z at which two planes meet that touch the scene on both sides. Both lean inward toward the viewer, by
     * [slope] along the axis [across] for a distance of 1.
     */
    fun apex(across: Vector3d, slope: Double): Double {
        val plus = farthest(across, 1.0, slope)
        val minus = farthest(across, -1.0, slope)
        return ((plus.across - minus.across) / slope + plus.z + minus.z) / 2
    }

    /**
     * Returns the coordinate along the axis [across] of an eye at [eyeZ], in front of the scene, for which the scene
     * extends equally far to both sides in the image.
     *
     * Planes of some slope that touch the scene on both sides meet at a z that falls when the slope rises, see [apex].
     * Newton's method finds the slope at which it is [eyeZ]: for the two points that are touched, the equation is
     * linear. It starts with too small a slope; the function is convex, so the slope rises from step to step and never
     * exceeds the solution. A scene with finitely many vertices has finitely many pairs of points, so it ends.
     */
    fun middle(across: Vector3d, eyeZ: Double): Double {
        var slope = 0.0
        while (true) {
            val plus = farthest(across, 1.0, slope)
            val minus = farthest(across, -1.0, slope)
            val next = (plus.across - minus.across) / (2 * eyeZ - plus.z - minus.z)
            if (!(next - slope > ROUNDING * next)) return (plus.across + minus.across + slope * (plus.z - minus.z)) / 2
            slope = next
        }
    }

    /** A point of the scene: its coordinate along an axis of the image, and its z. */
    private class Touched(val across: Double, val z: Double)

    /** Returns the point that is farthest along [sign] times [across] plus [slope] times backward. */
    private fun farthest(across: Vector3d, sign: Double, slope: Double): Touched {
        val point = farthest(
            Vector3d(
                sign * across.x + slope * backward.x,
                sign * across.y + slope * backward.y,
                sign * across.z + slope * backward.z,
            ),
        )
        return Touched(Vectors.dot(across, point), Vectors.dot(backward, point))
    }

    /** Returns the greatest coordinate along [sign] times [axis]. */
    private fun most(axis: Vector3d, sign: Double): Double =
        sign * Vectors.dot(axis, farthest(Vector3d(sign * axis.x, sign * axis.y, sign * axis.z)))

    private fun farthest(direction: Vector3d): Vector3d {
        val point = scene.farthest(direction) ?: box.farthest(direction)
        return Vectors.minus(point, center)
    }

    private fun pad(halfSize: Double): Double {
        val away = maxOf(StrictMath.abs(center.x), StrictMath.abs(center.y), StrictMath.abs(center.z))

        // A single point has no size: use a small positive one, because a camera needs near < far
        return if (halfSize > 0.0) halfSize * 0.01 + 1e-12 * away else 1e-6 * maxOf(away, 1e-6)
    }

    private companion object {
        /** A step of Newton's method that is smaller, relative to the slope, is due to rounding. */
        const val ROUNDING = 1e-15

        val UNIT_BOX = Box(-0.5, -0.5, -0.5, 0.5, 0.5, 0.5)
    }
}
