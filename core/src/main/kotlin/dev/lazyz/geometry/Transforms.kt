package dev.lazyz.geometry

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Matrix arithmetic with a fixed order of operations: the same bits on every machine (contract rule 6.3).
 *
 * JOML's own products use fused multiply-add if a JVM flag enables it, and its rotations use `Math.sin`, whose last bit
 * depends on the machine. So Lazy Z uses the types of JOML, and its own arithmetic. Use this class for transforms if
 * images must not differ between machines.
 */
public object Transforms {
    /**
     * Returns the product of [left] and [right]: the transform that applies [right], then [left]. A new matrix for each
     * call.
     */
    @JvmStatic
    public fun product(left: Matrix4dc, right: Matrix4dc): Matrix4d =
        // Use arrays: JOML accesses single elements by index through sun.misc.Unsafe
        Matrix4d().set(product(left.get(DoubleArray(16)), right.get(DoubleArray(16))))

    /** Same for arrays of 16 matrix elements, column by column. */
    internal fun product(a: DoubleArray, b: DoubleArray): DoubleArray {
        val product = DoubleArray(16)
        for (column in 0 until 4) {
            for (row in 0 until 4) {
                var sum = 0.0
                for (k in 0 until 4) sum += a[4 * k + row] * b[4 * column + k]
                product[4 * column + row] = sum
            }
        }
        return product
    }
}

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
