package dev.lazyz.scenes.text

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TextNumbersTest {
    @Test
    fun everySpellingOfNotANumberIsRead() {
        for (word in listOf("nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "1.#QNAN", "-1.#IND", "1.#SNAN")) {
            assertEquals(Double.NaN, TextNumbers.parse(word), word)
        }
    }

    @Test
    fun otherWordsAreNoNumbers() {
        for (word in listOf("", "x", "0,5", "1.2.3", "--1", "infinite", "na")) assertNull(TextNumbers.parse(word), word)
        assertEquals(-1.5e-3, TextNumbers.parse("-1.5E-3"))
    }

    @Test
    fun signBeforeTheExponentIsAMisprint() {
        assertEquals(310.0, TextNumbers.parse("3.1+e2"))
        assertEquals(-0.031, TextNumbers.parse("-3.1-E2"))
        assertEquals(310f, TextNumbers.parseFloat("3.1+e2"))
        for (word in listOf("3.1+2", "+e2", "3.1+e", "3.1+e+2", "..+e2")) assertNull(TextNumbers.parse(word), word)
    }

    @Test
    fun commaGetsAHint() {
        assertTrue("decimal point" in TextNumbers.remedy("0,5")!!)
        for (word in listOf("0,", ",0", "0,1,2", "0.5,1", "1.5,")) {
            assertTrue("spaces between numbers" in TextNumbers.remedy(word)!!, word)
        }
        assertNull(TextNumbers.remedy("x"))
    }
}
