package dev.lazyz.scenes.collections

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Lists grow up to the longest array, and no further. */
class GrowthTest {
    private val most = Int.MAX_VALUE - 8

    @Test
    fun listsGrowByHalf() {
        assertEquals(17, grownCapacity(1, 1))
        assertEquals(150, grownCapacity(100, 3))
        assertEquals(most, grownCapacity(1_500_000_000, 1))
    }

    @Test
    fun theLongestArrayIsTheLimit() {
        assertEquals(most, grownCapacity(most - 3, 3))
        val thrown = assertThrows(OutOfMemoryError::class.java) { grownCapacity(most - 2, 3) }
        assertEquals("an array cannot have 2147483640 elements", thrown.message)
    }
}
