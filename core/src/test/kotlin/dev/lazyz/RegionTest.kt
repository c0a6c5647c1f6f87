package dev.lazyz

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class RegionTest {
    private fun problem(columnStart: Int, rowStart: Int, columnEnd: Int, rowEnd: Int): String? =
        assertThrows(IllegalArgumentException::class.java) { Region(columnStart, rowStart, columnEnd, rowEnd) }.message

    @Test
    fun whatIsNoRegionIsNamed() {
        assertEquals("columnStart must not be negative: -1", problem(-1, 0, 1, 1))
        assertEquals("rowStart must not be negative: -2", problem(0, -2, 1, 1))
        assertEquals("columnEnd must be greater than columnStart, 3: 3", problem(3, 0, 3, 1))
        assertEquals("rowEnd must be greater than rowStart, 4: 2", problem(0, 4, 1, 2))
        assertEquals(1, Region(0, 0, 1, 1).size)
    }
}
