package dev.lazyz.scenes.teapot

/** A coordinate axis. */
internal enum class Axis { X, Y, Z }

/**
 * A bicubic Bezier patch: four rows of four control points, row after row, three coordinates each.
 *
 * u runs along a row, v from row to row.
 *
 * @property controlPoints the 48 coordinates; owned by the patch, must not be changed.
 */
internal class BezierPatch(val controlPoints: DoubleArray) {
    init {
        require(controlPoints.size == SIZE) { "a patch has $SIZE coordinates: ${controlPoints.size}" }
    }

    /** Returns the mirror image along [axis], with its rows reversed so that the outside stays outside. */
    fun mirrored(axis: Axis): BezierPatch {
        val image = DoubleArray(SIZE)
        for (point in 0 until SIDE * SIDE) {
            val row = point / SIDE
            val column = point % SIDE
            val from = AXES * (row * SIDE + SIDE - 1 - column)
            for (coordinate in 0 until AXES) {
                val value = controlPoints[from + coordinate]
                // Subtract instead of negating: the mirror image of 0 is 0, not -0
                image[AXES * point + coordinate] = if (coordinate == axis.ordinal) 0.0 - value else value
            }
        }
        return BezierPatch(image)
    }

    override fun toString(): String = "BezierPatch(${controlPoints.joinToString()})"

    companion object {
        /** Control points per row, and rows per patch. */
        const val SIDE: Int = 4

        /** Coordinates per control point. */
        const val AXES: Int = 3

        private const val SIZE = SIDE * SIDE * AXES
    }
}

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
