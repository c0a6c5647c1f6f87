package dev.lazyz.scenes.teapot

/**
 * The cubic Bernstein polynomials, and the quadratic ones of their derivative, at the parameters 0, 1/n, ..., 1.
 *
 * Uses only `+ - * /` in double precision, so the values are bit for bit the same on every machine. A curve and its
 * reverse (control points in reverse order) have bit for bit the same points at mirrored parameters, and a curve
 * starts and ends exactly at its outer control points. Therefore patches with a common border meet without a crack.
 *
 * Source: Gerald Farin, "Curves and Surfaces for CAGD", the chapter on the Bernstein form.
 */
internal class CubicBasis(segments: Int) {
    private val weights = DoubleArray(4 * (segments + 1))
    private val slopeWeights = DoubleArray(3 * (segments + 1))

    init {
        for (step in 0..segments) {
            // Two divisions: 1 - t would round differently from the t of the opposite step
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

    /** Returns the value at [step] of the cubic with the four coefficients at [first], [first] + [stride], ... */
    fun value(coefficients: DoubleArray, first: Int, stride: Int, step: Int): Double {
        val at = 4 * step
        // Add the outer and the inner terms in pairs: the sum is then the same for the reversed curve
        val outer = weights[at] * coefficients[first] + weights[at + 3] * coefficients[first + 3 * stride]
        val inner =
            weights[at + 1] * coefficients[first + stride] + weights[at + 2] * coefficients[first + 2 * stride]
        return outer + inner
    }

    /**
     * Returns the derivative of [value] with respect to the parameter. Exactly zero where the coefficients are equal.
     */
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
