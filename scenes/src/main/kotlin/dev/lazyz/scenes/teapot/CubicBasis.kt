package dev.lazyz.scenes.teapot

/**
 * The cubic Bernstein polynomials and the quadratic ones of the derivative, at the parameters 0, 1/n, ..., 1.
 *
 * Only `+ - * /` in double precision, so the values are the same bits on every machine. A curve and the same curve with
 * its control points reversed meet in the same bits at mirrored parameters, and a curve starts and ends exactly at its
 * outer control points; together they make patches with a common border meet without a crack.
 *
 * Source: Gerald Farin, "Curves and Surfaces for CAGD", the chapter on the Bernstein form.
 */
internal class CubicBasis(segments: Int) {
    private val weights = DoubleArray(4 * (segments + 1))
    private val slopeWeights = DoubleArray(3 * (segments + 1))

    init {
        for (step in 0..segments) {
            // Divide twice: 1 - t would round differently from the t of the opposite step
            val t = step.toDouble() / segments
            val s = (segments - step).toDouble() / segments
            weights[4 * step] = s * s * s
            weights[4 * step + 1] = 3.0 * (s * s) * t
            weights[4 * step + 2] = 3.0 * (t * t) * s
            weights[4 * step + 3] = t * t * t
            slopeWeights[3 * step] = 3.0 * (s * s)
            slopeWeights[3 * step + 1] = 6.0 * (s * t)
            slopeWeights[3 * step + 2] = 3.0 * (t * t)
        }
    }

    /** The value at [step] of the cubic with the four coefficients at [first], [first] + [stride], ... */
    fun value(coefficients: DoubleArray, first: Int, stride: Int, step: Int): Double {
        val at = 4 * step
        // Pair the outer and the inner terms: the sum is then the same in reverse
        val outer = weights[at] * coefficients[first] + weights[at + 3] * coefficients[first + 3 * stride]
        val inner =
            weights[at + 1] * coefficients[first + stride] + weights[at + 2] * coefficients[first + 2 * stride]
        return outer + inner
    }

    /** The derivative of [value] by the parameter. Zero, and not nearly zero, where the coefficients are equal. */
    fun slope(coefficients: DoubleArray, first: Int, stride: Int, step: Int): Double {
        val at = 3 * step
        val c1 = coefficients[first + stride]
        val c2 = coefficients[first + 2 * stride]
        val outer =
            slopeWeights[at] * (c1 - coefficients[first]) +
                slopeWeights[at + 2] * (coefficients[first + 3 * stride] - c2)
        return outer + slopeWeights[at + 1] * (c2 - c1)
    }
}
