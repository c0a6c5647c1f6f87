package dev.lazyz.scenes.pictures

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PixelFontTest {
    @Test
    fun everyPrintableCharacterHasALetterOfItsOwn() {
        val letters = (' '..'~').map { pixels("$it") }
        assertEquals(letters.size, letters.toSet().size)
        assertTrue(letters.all { letter -> letter.chunked(PixelFont.ADVANCE).none { it.last() } })
        assertEquals(pixels("?"), pixels("\u00df"))
    }

    @Test
    fun accentsAreNotDrawn() {
        assertEquals(pixels("Curaca"), pixels("C\u00fcra\u00e7\u00e3"))
    }

    @Test
    fun lettersFollowEachOther() {
        assertEquals(listOf(0, 5, 11), listOf("", "A", "AB").map { PixelFont.width(it) })
        assertEquals(
            pixels("A").chunked(PixelFont.ADVANCE).zip(pixels("B").chunked(PixelFont.ADVANCE)) { a, b ->
                a + b
            }.flatten(),
            pixels("AB"),
        )
    }

    private fun pixels(text: String) = (0 until PixelFont.HEIGHT).flatMap { row ->
        (0 until PixelFont.ADVANCE * text.length).map { PixelFont.isSet(text, it, row) }
    }
}
