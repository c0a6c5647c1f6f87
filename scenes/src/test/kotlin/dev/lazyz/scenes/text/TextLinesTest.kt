package dev.lazyz.scenes.text

import dev.lazyz.scenes.loading.TestSources
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TextLinesTest {
    @Test
    fun everyLineEndCountsOnce() {
        val lines = TextLines(TestSources.of("a\nb\r\nc\rd\n\ne"))
        val read = generateSequence { lines.next()?.let { Pair(lines.number, it) } }.toList()
        assertEquals(listOf(1 to "a", 2 to "b", 3 to "c", 4 to "d", 5 to "", 6 to "e"), read)
        assertNull(lines.next())
        assertEquals(6, lines.number)
    }

    @Test
    fun wordsPassOverEmptyLines() {
        val lines = TextLines(TestSources.of("\n \t\n a \t B\n"))
        assertTrue(lines.nextWordOfText() && lines.isWord("a") && lines.number == 3)
        assertEquals(1, lines.countWords())
        assertFalse(lines.isBlank())
        assertTrue(lines.nextWord() && lines.isWord("b"))
        assertEquals("B", lines.word())
        assertTrue(lines.isBlank())
        assertFalse(lines.nextWord())
        assertFalse(lines.nextWordOfText())
    }
}
