package dev.lazyz.geometry

import org.joml.Vector3d
import org.joml.Vector3dc

/** Vector arithmetic with a fixed order of operations, see [Transforms]. */
internal object Vectors {
    /** Maximum rounding error of the squared length of a vector whose components were divided by its length. */
    private const val ROUNDING = 8 * 2.220446049250313e-16

    /**
     * Returns [v] scaled to unit length. A vector whose length is already 1, up to rounding, is returned unchanged, so
     * that a vector that is written to a file and read again keeps its bits.
     *
     * @param what name of the vector, for the message of the exception
     * @throws IllegalArgumentException if [v] is zero or not finite
     */
    fun unit(v: Vector3dc, what: String): Vector3d {
        val square = v.x() * v.x() + v.y() * v.y() + v.z() * v.z()
        if (StrictMath.abs(square - 1.0) <= ROUNDING) return Vector3d(v)
        val length = StrictMath.sqrt(square)
        require(length > 0.0 && length.isFinite()) { "$what must be finite and not zero, and so must its length: $v" }
        return Vector3d(v.x() / length, v.y() / length, v.z() / length)
    }

    /** Whether all components are finite. JOML's own method loads its text formats, and with them Java's locales. */
    fun isFinite(v: Vector3dc): Boolean = v.x().isFinite() && v.y().isFinite() && v.z().isFinite()

    val ZERO: Vector3dc = Vector3d()

    fun isZero(v: Vector3dc): Boolean = v.x() == 0.0 && v.y() == 0.0 && v.z() == 0.0

    fun minus(a: Vector3dc, b: Vector3dc): Vector3d = Vector3d(a.x() - b.x(), a.y() - b.y(), a.z() - b.z())

    fun cross(a: Vector3dc, b: Vector3dc): Vector3d = Vector3d(
        a.y() * b.z() - a.z() * b.y(),
        a.z() * b.x() - a.x() * b.z(),
        a.x() * b.y() - a.y() * b.x(),
    )

    fun dot(a: Vector3dc, b: Vector3dc): Double = a.x() * b.x() + a.y() * b.y() + a.z() * b.z()
}
