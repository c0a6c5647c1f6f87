package dev.lazyz.scenes.teapot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CubicBasisTest {
    private val curve = doubleArrayOf(0.1, -7.3, 2.9, 1.7)

    @Test
    fun endsAreTheOuterCoefficientsExactly() {
        for (n in 1..256) {
            val basis = CubicBasis(n)
            assertEquals(0.1, basis.value(curve, 0, 1, 0))
            assertEquals(1.7, basis.value(curve, 0, 1, n))
        }
    }

    @Test
    fun reversedCurveHasTheSameBits() {
        val reversed = curve.reversedArray()
        for (n in 1..256) {
            val basis = CubicBasis(n)
            for (step in 0..n) {
                assertEquals(basis.value(curve, 0, 1, step), basis.value(reversed, 0, 1, n - step), "$step of $n")
                assertEquals(basis.slope(curve, 0, 1, step), -basis.slope(reversed, 0, 1, n - step), "$step of $n")
            }
        }
    }

    @Test
    fun slopeOfEqualCoefficientsIsZero() {
        val point = DoubleArray(4) { 0.1 }
        for (n in 1..256) {
            val basis = CubicBasis(n)
            for (step in 0..n) assertEquals(0.0, basis.slope(point, 0, 1, step), "$step of $n")
        }
    }

    @Test
    fun cubicIsReproduced() {
        // t^3 has the Bernstein coefficients 0, 0, 0, 1 and the derivative 3 t^2; interleave to use the stride
        val power = doubleArrayOf(9.0, 0.0, 9.0, 0.0, 9.0, 0.0, 9.0, 1.0)
        val basis = CubicBasis(8)
        for (step in 0..8) {
            val t = step / 8.0
            assertEquals(t * t * t, basis.value(power, 1, 2, step))
            assertEquals(3.0 * t * t, basis.slope(power, 1, 2, step))
        }
    }

    @Test
    fun slopeIsTheDerivativeOfTheValue() {
        val basis = CubicBasis(1000)
        for (step in 1..999) {
            val difference = (basis.value(curve, 0, 1, step + 1) - basis.value(curve, 0, 1, step - 1)) * 500.0
            assertEquals(difference, basis.slope(curve, 0, 1, step), 1e-3, "step $step")
        }
    }
}
