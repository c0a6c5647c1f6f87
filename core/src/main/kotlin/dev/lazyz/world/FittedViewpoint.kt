package dev.lazyz.world

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import org.joml.Vector3d

/**
 * A rule that fits the whole scene into the image, seen from a given direction. Created by [Camera.fit]. The world's y
 * axis is up. Immutable.
 *
 * @property azimuth degrees around the up axis; 0 is the front (+z), 90 is +x
 * @property elevation degrees above the horizon, -90..90
 * @property zoom 1 fills the image except for a margin of 5 percent
 * @property kind perspective or orthographic
 */
public class FittedViewpoint internal constructor(
    public val azimuth: Double,
    public val elevation: Double,
    public val zoom: Double,
    public val kind: Fit,
) : Viewpoint {
    override fun camera(bounds: Box?, aspect: Double): Camera {
        val box = bounds ?: UNIT_BOX
        val center = box.center
        val direction = direction()
        val up = if (StrictMath.abs(elevation) == 90.0) upAtPole() else Vector3d(0.0, 1.0, 0.0)

        // Measure the box in the camera's axes, about its centre
        val probe = Camera.orthographic(direction, Vector3d(), up, 1.0, 0.0, 1.0)
        var halfWidth = 0.0
        var halfHeight = 0.0
        var halfDepth = 0.0
        var distance = 0.0
        val halfAngleTangent = StrictMath.tan(Camera.DEFAULT_FIELD_OF_VIEW * (StrictMath.PI / 360.0))
        val slope = halfAngleTangent * FILL
        for (number in 0 until 8) {
            val corner = box.corner(number)
            corner.set(corner.x - center.x, corner.y - center.y, corner.z - center.z)
            val x = StrictMath.abs(Vectors.dot(corner, probe.right))
            val y = StrictMath.abs(Vectors.dot(corner, probe.upward))
            val z = Vectors.dot(corner, probe.backward)
            halfWidth = maxOf(halfWidth, x)
            halfHeight = maxOf(halfHeight, y)
            halfDepth = maxOf(halfDepth, StrictMath.abs(z))
            distance = maxOf(distance, z + y / slope, z + x / (slope * aspect))
        }

        val pad = pad(maxOf(halfWidth, halfHeight, halfDepth), center)
        return when (kind) {
            Fit.ORTHOGRAPHIC -> {
                val height = 2 * maxOf(halfHeight, halfWidth / aspect, pad) / (FILL * zoom)
                val back = halfDepth + pad
                Camera.orthographic(at(center, direction, 2 * back), center, up, height, back, 3 * back)
            }
            Fit.PERSPECTIVE -> {
                val away = maxOf(distance, halfDepth + 2 * pad)
                val near = maxOf(away - halfDepth - pad, away / 1024)
                val fieldOfView = StrictMath.atan(halfAngleTangent / zoom) * (360.0 / StrictMath.PI)
                Camera.perspective(
                    at(center, direction, away), center, up, fieldOfView, near, away + halfDepth + pad,
                )
            }
        }
    }

    /** Direction from the centre of the scene to the camera; unit length. */
    private fun direction(): Vector3d {
        val a = azimuth * (StrictMath.PI / 180.0)
        val e = elevation * (StrictMath.PI / 180.0)
        val horizontal = StrictMath.cos(e)
        return Vector3d(StrictMath.sin(a) * horizontal, StrictMath.sin(e), StrictMath.cos(a) * horizontal)
    }

    /** Up direction for a view from straight above or below: the horizontal direction given by the azimuth. */
    private fun upAtPole(): Vector3d {
        val a = azimuth * (StrictMath.PI / 180.0)
        val sign = if (elevation > 0) -1.0 else 1.0
        return Vector3d(StrictMath.sin(a) * sign, 0.0, StrictMath.cos(a) * sign)
    }

    private fun at(center: Vector3d, direction: Vector3d, distance: Double): Vector3d = Vector3d(
        center.x + direction.x * distance,
        center.y + direction.y * distance,
        center.z + direction.z * distance,
    )

    /** Distance between the planes and a scene of the given half size, in front of the scene and behind it. */
    private fun pad(halfSize: Double, center: Vector3d): Double {
        val away = maxOf(StrictMath.abs(center.x), StrictMath.abs(center.y), StrictMath.abs(center.z))

        // A single point has no size: use a small positive one, because a camera needs near < far
        return if (halfSize > 0.0) halfSize * 0.01 + 1e-12 * away else 1e-6 * maxOf(away, 1e-6)
    }

    override fun toString(): String = "FittedViewpoint(azimuth=$azimuth, elevation=$elevation, zoom=$zoom, $kind)"

    private companion object {
        /** Part of the image that a fitted scene fills. */
        const val FILL = 0.95

        val UNIT_BOX = Box(-0.5, -0.5, -0.5, 0.5, 0.5, 0.5)
    }
}

/** The projection of a fitted camera, see [Camera.fit]. */
public enum class Fit {
    /** Perspective, with a vertical field of view of [Camera.DEFAULT_FIELD_OF_VIEW] degrees. */
    PERSPECTIVE,

    /** Orthographic. */
    ORTHOGRAPHIC,
}
