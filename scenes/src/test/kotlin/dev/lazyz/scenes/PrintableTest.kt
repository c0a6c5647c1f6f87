package dev.lazyz.scenes

import dev.lazyz.scenes.formats.Scenes
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PrintableTest {
    @Test
    fun whatATerminalObeysIsReplaced() {
        assertEquals("a?[31mred?b??", printable("a\u001B[31mred\u0007b\u202E\u2028"))
        assertEquals("Müller 木.png", printable("Müller 木.png"))
    }

    @Test
    fun longWordsAreCut() {
        val shown = printable("word ${"x".repeat(100_000)} end")
        assertEquals("word ${"x".repeat(400)}... end", shown)
    }

    @Test
    fun messagesAndWarningsArePrintable() {
        val text = "mtllib \u001B]0;pwned\u0007.mtl\nv 0 0 0\nusemtl \u001B[31mred\nf 1 1 1\n"
        val loaded = Scenes.load(text.byteInputStream(), SceneFormat.OBJ)
        assertTrue(loaded.warnings.isNotEmpty())
        for (warning in loaded.warnings) assertFalse(warning.any { it.isISOControl() }, warning)
        val failure = SceneFormatException("a\u001Bb", "line 1", "bad\nword")
        assertEquals("a?b, line 1: bad?word", failure.message)
    }
}
