package dev.lazyz

import java.util.Random
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

    @Test
    fun anIntersectionHasTheSamplesOfBoth() {
        val random = Random(43)
        fun region(): Region {
            val (left, top, width, height) = List(4) { random.nextInt(5) }
            return Region(left, top, left + 1 + width, top + 1 + height)
        }
        fun samples(region: Region?) = (0 until 100).filter { region != null && region.contains(it % 10, it / 10) }
        repeat(1000) {
            val (a, b) = List(2) { region() }
            val common = a.intersect(b)
            assertEquals(samples(a).intersect(samples(b).toSet()).toList(), samples(common)) { "$a, $b" }
            assertEquals(common, b.intersect(a))
        }
    }

    @Test
    fun rowsAreThoseOfTheRegion() {
        val region = Region(2, 3, 5, 9)
        assertEquals(Region(2, 4, 5, 6), region.rows(4, 6))
        assertEquals(region, region.rows(-1, 100))
        val none = assertThrows(IllegalArgumentException::class.java) { region.rows(9, 12) }
        assertEquals("rowEnd must be greater than rowStart, 9: 9", none.message)
    }
}
