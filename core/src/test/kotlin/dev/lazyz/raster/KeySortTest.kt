package dev.lazyz.raster

import dev.lazyz.Checkpoint
import java.util.Random
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class KeySortTest {
    private val random = Random(1)
    private val inputs = mapOf<String, (Int) -> Long>(
        "random" to { random.nextLong() },
        "ascending" to { it.toLong() },
        "descending" to { -it.toLong() },
        "equal" to { 7L },
        "two keys" to { it % 2L },
        "a greatest key in front" to { if (it == 0) Long.MAX_VALUE else it.toLong() },
    )

    @Test
    fun keysAreSortedLikeTheJdkSortsThem() {
        for ((name, key) in inputs) {
            for (size in listOf(0, 1, 1000, 700_000)) {
                val keys = LongArray(size, key)
                val expected = keys.copyOf().apply { sort(size / 10, size) }
                keys.sortKeys(Checkpoint.NONE, size / 10)
                assertArrayEquals(expected, keys, name)
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aSortEndsAtACheckpointAmongManyKeys() {
        for ((name, key) in inputs) {
            var passed = 0
            val size = 1_600_000
            LongArray(size, key).sortKeys({ passed++ })
            assertTrue(passed >= size / 400_000, "$name: $passed")
        }
        assertEquals("end", assertThrows<IllegalStateException> { LongArray(9).sortKeys({ error("end") }) }.message)
    }
}
