package dev.lazyz

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Vector and matrix arithmetic with one order of operations, spelled out.
 *
 * JOML's own products may use fused multiply-add when a JVM flag says so, and its rotations use `Math.sin`, whose last
 * bit is the machine's choice. Both would break contract rule 6.3, so JOML gives the types and this file the arithmetic.
 */
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

    /** Returns the product of [left] and [right]: apply [right] first. */
    fun product(left: Matrix4dc, right: Matrix4dc): Matrix4d {
        val result = Matrix4d()
        for (column in 0 until 4) {
            for (row in 0 until 4) {
                var sum = 0.0
                for (k in 0 until 4) sum += left.get(k, row) * right.get(column, k)
                result.set(column, row, sum)
            }
        }
        return result
    }
}
