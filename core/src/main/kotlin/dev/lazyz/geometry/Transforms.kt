package dev.lazyz.geometry

import org.joml.Matrix4d
import org.joml.Matrix4dc

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
