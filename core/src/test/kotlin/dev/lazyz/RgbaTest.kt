package dev.lazyz

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RgbaTest {
    @Test
    fun textBecomesColour() {
        assertEquals(0xFF336699.toInt(), Rgba.parse("#336699").toArgb())
        assertEquals(0xFF336699.toInt(), Rgba.parse("#369").toArgb())
        assertEquals(0x80ABCDEF.toInt(), Rgba.parse("#AbCdEf80").toArgb())
        assertEquals(Rgba.TRANSPARENT, Rgba.parse("transparent"))
        assertEquals(Rgba.BLACK, Rgba.parse("black"))
        assertEquals(Rgba.WHITE, Rgba.parse("white"))
        assertEquals(Rgba.WHITE, Rgba.parse("#fff"))
    }

    @Test
    fun otherTextIsNamedInTheMessage() {
        val wrong =
            listOf("", "#", "#12", "#1234", "#12345", "#1234567", "#123456789", "red", "#ggg", "fff", " #fff", "#fff\n")
        for (text in wrong) {
            val message = assertThrows(IllegalArgumentException::class.java) { Rgba.parse(text) }.message
            assertTrue(message!!.endsWith(text)) { message }
        }
    }

    @Test
    fun coloursAreValues() {
        assertEquals(Rgba(0.1f, 0.2f, 0.3f, 0.4f), Rgba(0.1f, 0.2f, 0.3f).withAlpha(0.4f))
        assertEquals(Rgba(0.2f, 0.4f, 0.6f, 0.5f), Rgba(0.1f, 0.2f, 0.3f, 0.5f).scaled(2f))
        assertEquals(Rgba.WHITE.hashCode(), Rgba(1f, 1f, 1f).hashCode())
        assertTrue(Rgba.WHITE != Rgba.BLACK && !Rgba.WHITE.equals("white"))
    }
}
