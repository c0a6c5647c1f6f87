package dev.lazyz.sections

import dev.lazyz.geometry.Vectors
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A plane that cuts a scene. What is on the side that [normal] points to is removed: all points p whose product with
 * the normal, at unit length, is greater than [distance]. Immutable.
 *
 * @param normal points to the removed side, of any length
 * @property distance distance of the plane from the world's origin along the normal, world units
 * @throws IllegalArgumentException if the normal is zero, or a number is not finite
 */
public class SectionPlane(normal: Vector3dc, public val distance: Double) {
    /** Points to the removed side; unit length. */
    public val normal: Vector3dc

    init {
        require(distance.isFinite()) { "distance must be finite: $distance" }
        this.normal = Vectors.unit(normal, "normal")
    }

    /** Returns the distance of the point ([x], [y], [z]) from the plane, positive on the removed side, world units. */
    internal fun height(x: Double, y: Double, z: Double): Double {
        val height = normal.x() * x + normal.y() * y + normal.z() * z - distance
        val size = StrictMath.abs(normal.x() * x) + StrictMath.abs(normal.y() * y) + StrictMath.abs(normal.z() * z)

        // What differs from 0 only by rounding is on the plane
        return if (StrictMath.abs(height) <= ROUNDING * (size + StrictMath.abs(distance))) 0.0 else height
    }

    override fun toString(): String = "${normal.x()},${normal.y()},${normal.z()},$distance"

    public companion object {
        /** More than the rounding error of a height, as a part of its terms. */
        private const val ROUNDING = 1e-13

        /** Returns the plane [x] that removes what has a greater x. */
        @JvmStatic
        public fun x(x: Double): SectionPlane = SectionPlane(Vector3d(1.0, 0.0, 0.0), x)

        /** Returns the plane [y] that removes what has a greater y. */
        @JvmStatic
        public fun y(y: Double): SectionPlane = SectionPlane(Vector3d(0.0, 1.0, 0.0), y)

        /** Returns the plane [z] that removes what has a greater z. */
        @JvmStatic
        public fun z(z: Double): SectionPlane = SectionPlane(Vector3d(0.0, 0.0, 1.0), z)
    }

    /** Returns the same plane, which removes the other side. */
    public fun reversed(): SectionPlane =
        SectionPlane(Vector3d(-normal.x(), -normal.y(), -normal.z()), -distance)
}
