package dev.lazyz.geometry

import org.joml.Matrix4d
import org.joml.Matrix4dc

/**
 * Matrix arithmetic with one order of operations, the same bits on every machine (contract rule 6.3).
 *
 * JOML's own products may use fused multiply-add when a JVM flag says so, and its rotations use `Math.sin`, whose last
 * bit is the machine's choice. So JOML gives the types, and Lazy Z the arithmetic; use this for transforms whose pictures
 * must not differ between machines.
 */
public object Transforms {
    /** Returns the product of [left] and [right]: the transform that applies [right], then [left]. */
    @JvmStatic
    public fun product(left: Matrix4dc, right: Matrix4dc): Matrix4d =
        // Through arrays: JOML's access to single elements by number goes through sun.misc.Unsafe
        Matrix4d().set(product(left.get(DoubleArray(16)), right.get(DoubleArray(16))))

    /** The same of the elements of matrices, column by column. */
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
