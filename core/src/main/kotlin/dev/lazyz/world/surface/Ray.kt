package dev.lazyz.world.surface

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A ray through a sample, in world space. Immutable.
 *
 * @property origin where it starts: the camera's eye for perspective, otherwise a point in the plane of the eye
 * @property direction its direction, of such a length that its component along the line of sight is 1
 */
public class Ray internal constructor(public val origin: Vector3dc, public val direction: Vector3dc) {
    /** Returns the point at [distance] from the camera along the line of sight, world units. A new vector. */
    public fun at(distance: Double): Vector3d = Vector3d(
        origin.x() + direction.x() * distance,
        origin.y() + direction.y() * distance,
        origin.z() + direction.z() * distance,
    )

    override fun toString(): String = "Ray($origin, $direction)"
}
