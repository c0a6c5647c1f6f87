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

    private fun pixels(text: String) = (0 until PixelFont.HEIGHT).flatMap { row ->
        (0 until PixelFont.ADVANCE * text.length).map { PixelFont.isSet(text, it, row) }
    }
}
