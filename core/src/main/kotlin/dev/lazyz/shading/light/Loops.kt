package dev.lazyz.shading.light

import dev.lazyz.spi.FragmentBatch
import kotlin.math.sqrt

/**
 * Short loops over the first `count` elements of arrays, each of which the JVM vectorises. Three arrays in a row of an
 * array of arrays are the x, y and z of vectors.
 */
internal object Loops {
    private const val LARGE = 1.7014118346046923e38f

    /** `out = factor * from` */
    fun product(from: FloatArray, factor: Float, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = factor * from[i]
    }

    /** `a = a * b` */
    fun multiply(a: FloatArray, b: FloatArray, count: Int) {
        for (i in 0 until count) a[i] = a[i] * b[i]
    }

    /** `a = a / by` */
    fun divide(a: FloatArray, by: FloatArray, count: Int) {
        for (i in 0 until count) a[i] = a[i] / by[i]
    }

    /** `out = a + b` */
    fun sum(a: FloatArray, b: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = a[i] + b[i]
    }

    /** `out = target - from` */
    fun towards(target: Float, from: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = target - from[i]
    }

    /** `out = max(from, 0)` */
    fun positive(from: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = maxOf(from[i], 0f)
    }

    /** Returns 1 for numbers above 0, and 0 for others: any number above 0, times 2^254, is at least 1. */
    fun step(x: Float): Float = minOf(maxOf(x, 0f) * LARGE * LARGE, 1f)

    fun lengths(vectors: Array<FloatArray>, at: Int, out: FloatArray, count: Int) =
        lengths(vectors[at], vectors[at + 1], vectors[at + 2], out, count)

    private fun lengths(x: FloatArray, y: FloatArray, z: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
    }

    /** Divides the vectors at [at] by their [lengths]. */
    fun toUnit(vectors: Array<FloatArray>, at: Int, lengths: FloatArray, count: Int) {
        lengths(vectors, at, lengths, count)
        for (axis in 0 until 3) divide(vectors[at + axis], lengths, count)
    }

    fun dot(vectors: Array<FloatArray>, a: Int, b: Int, out: FloatArray, count: Int) = dot(
        vectors[a], vectors[a + 1], vectors[a + 2], vectors[b], vectors[b + 1], vectors[b + 2], out, count,
    )

    private fun dot(
        ax: FloatArray,
        ay: FloatArray,
        az: FloatArray,
        bx: FloatArray,
        by: FloatArray,
        bz: FloatArray,
        out: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i]
    }
}

/** Whether no colour of the batch is NaN. */
internal fun FragmentBatch.hasNumbers(): Boolean {
    for (i in 0 until size) if ((red[i] + green[i] + blue[i]).isNaN()) return false
    return true
}
