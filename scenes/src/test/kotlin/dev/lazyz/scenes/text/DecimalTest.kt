package dev.lazyz.scenes.text

import java.math.BigDecimal
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** [Decimal] either says that it is not certain, or gives the bits of Java's own parser. */
class DecimalTest {
    private val decimal = Decimal()

    private fun float(word: String): Float = " $word ".toByteArray().let { decimal.float(it, 1, it.size - 1) }

    private fun double(word: String): Double = " $word ".toByteArray().let { decimal.double(it, 1, it.size - 1) }

    private fun assertAgrees(word: String) {
        val float = float(word)
        if (!float.isNaN()) assertEquals(word.toFloat().toRawBits(), float.toRawBits(), word)
        val double = double(word)
        if (!double.isNaN()) assertEquals(word.toDouble().toRawBits(), double.toRawBits(), word)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun randomDecimalsAreJavas() {
        val random = Random(1)
        var certain = 0
        repeat(1_000_000) {
            val word = word(random)
            assertAgrees(word)
            if (!float(word).isNaN()) certain++
        }
        assertTrue(certain > 500_000, "only $certain of a million are certain")
    }

    private fun word(random: Random): String = buildString {
        append(listOf("", "-", "+")[random.nextInt(3)])
        val digits = random.nextInt(1, 20)
        val point = random.nextInt(-1, digits + 1)
        for (i in 0 until digits) {
            if (i == point) append('.')
            append(random.nextInt(10))
        }
        if (random.nextInt(3) == 0) append("eE"[random.nextInt(2)]).append(random.nextInt(-60, 40))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun decimalsNextToTheMiddleOfTwoFloatsAreJavas() {
        val random = Random(2)
        repeat(200_000) {
            // The middle itself, and a little to each side of it
            val low = Float.fromBits(random.nextInt(0x20000000, 0x60000000))
            val high = Math.nextUp(low)
            val middle = (BigDecimal(low.toDouble()) + BigDecimal(high.toDouble())) / BigDecimal(2)
            for (digits in listOf(9, 15, 17, 18, 19)) {
                assertAgrees(middle.round(java.math.MathContext(digits)).toString())
            }
            assertAgrees(middle.toPlainString())
        }
    }

    @Test
    fun theCommonFormsAreCertain() {
        val words =
            listOf("0", "-0", "-0.0", "1", "0.1", "-12.345678", "1e5", "3.14159265358979", "2.5E-07", ".5", "5.")
        for (word in words) {
            assertEquals(word.toFloat().toRawBits(), float(word).toRawBits(), word)
            assertEquals(word.toDouble().toRawBits(), double(word).toRawBits(), word)
        }
        assertEquals(1.1102230246251565e-16f, float("1.1102230246251565e-16"))
    }

    @Test
    fun whatIsNoDecimalIsLeftToOthers() {
        val words = listOf("", "-", "+", ".", "e5", "1e", "1e+", "1.2.3", "--1", "1-2", "0x1", "1f", "nan", "1e999")
        for (word in words) {
            assertTrue(float(word).isNaN() && double(word).isNaN(), word)
        }
    }
}
