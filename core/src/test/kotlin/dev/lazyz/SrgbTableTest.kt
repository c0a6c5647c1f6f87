package dev.lazyz

import dev.lazyz.spi.Srgb
import java.math.BigDecimal
import java.math.BigInteger
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/**
 * Contract rule 6.4, without rounding: the curve's exponent 2.4 is 12/5, so a value and a point of the curve can be
 * compared as integer powers of rational numbers.
 */
class SrgbTableTest {
    /** The sign of [linear] minus the decoded sRGB value [numerator] / [denominator]. Exact. */
    private fun compare(linear: BigDecimal, numerator: Long, denominator: Long): Int {
        // At 0.04045 and below, a straight line: linear * 12.92 against s
        if (100_000L * numerator <= 4045L * denominator) {
            return (linear * BigDecimal(1292L * denominator)).compareTo(BigDecimal(100L * numerator))
        }
        // ((s + 0.055) / 1.055)^12 against linear^5, both times the denominator's 12th power
        val above = BigDecimal(BigInteger.valueOf(1000 * numerator + 55 * denominator).pow(12))
        val below = BigDecimal(BigInteger.valueOf(1055 * denominator).pow(12))
        return (linear.pow(5) * below).compareTo(above)
    }

    private fun exact(value: Float) = BigDecimal(value.toDouble())

    /** Whether [linear] is at least the value half a code below [code]. */
    private fun reaches(linear: Float, code: Int): Boolean = compare(exact(linear), 2L * code - 1, 510) >= 0

    /** The smallest value of each code. */
    private val leastOfCode = FloatArray(256) { code ->
        var low = 0
        var high = 1f.toRawBits()
        while (low < high) {
            // Positive floats have the same order as their bits
            val middle = (low + high) / 2
            if (code == 0 || reaches(Float.fromBits(middle), code)) high = middle else low = middle + 1
        }
        Float.fromBits(low)
    }

    private fun code(linear: Float): Int = leastOfCode.indexOfLast { it <= linear }

    @Test
    fun rule_6_4_everyCodeBeginsWhereTheCurveSays() {
        for (code in 1..255) {
            val least = leastOfCode[code]
            assertTrue(least > leastOfCode[code - 1] && reaches(least, code) && !reaches(Math.nextDown(least), code))
            assertEquals(code, Srgb.encode(least)) { "least value of code $code" }
            assertEquals(code, Srgb.encode(Math.nextUp(least))) { "above the least value of code $code" }
            assertEquals(code - 1, Srgb.encode(Math.nextDown(least))) { "below code $code" }
        }
    }

    @Test
    fun rule_6_4_everyEntryOfTheTableHoldsFromItsFirstToItsLastValue() {
        // 256 entries an octave: an error of one float would be visible at an end of an entry, or next to the step
        // within it
        for (bits in Srgb.LEAST_BITS / 2..1.1f.toRawBits() step (1 shl Srgb.BUCKET_SHIFT)) {
            val first = Float.fromBits(bits)
            for (linear in listOf(first, Math.nextUp(first), Math.nextDown(first).coerceAtLeast(0f))) {
                assertEquals(code(linear), Srgb.encode(linear)) { "$linear" }
            }
        }
    }

    @Test
    fun rule_6_4_everyCodeDecodesToTheFloatNextToTheCurve() {
        for (code in 1..255) {
            val linear = Srgb.decode(code)
            val lower = (exact(Math.nextDown(linear)) + exact(linear)) / BigDecimal(2)
            val upper = (exact(Math.nextUp(linear)) + exact(linear)) / BigDecimal(2)
            assertTrue(compare(lower, code.toLong(), 255) <= 0 && compare(upper, code.toLong(), 255) >= 0) {
                "code $code is $linear"
            }
        }
        assertEquals(0f, Srgb.decode(0))
        assertEquals(1f, Srgb.decode(255))
    }
}
