package dev.lazyz

import org.joml.Vector3d
import org.joml.Vector3dc

/** Vector arithmetic with one order of operations, see [Transforms]. */
internal object Vectors {
    fun unit(v: Vector3dc, what: String): Vector3d {
        val length = StrictMath.sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z())
        require(length > 0.0 && length.isFinite()) { "$what must be finite and not zero: $v" }
        return Vector3d(v.x() / length, v.y() / length, v.z() / length)
    }

    fun cross(a: Vector3dc, b: Vector3dc): Vector3d = Vector3d(
        a.y() * b.z() - a.z() * b.y(),
        a.z() * b.x() - a.x() * b.z(),
        a.x() * b.y() - a.y() * b.x(),
    )

    fun dot(a: Vector3dc, b: Vector3dc): Double = a.x() * b.x() + a.y() * b.y() + a.z() * b.z()
}
