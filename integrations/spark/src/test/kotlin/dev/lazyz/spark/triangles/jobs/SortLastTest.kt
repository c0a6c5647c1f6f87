package dev.lazyz.spark.triangles.jobs

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class SortLastTest {
    @Test
    fun eightPartsAreMergedAtATime() {
        assertEquals(listOf(1), SortLast.groups(1))
        assertEquals(listOf(1), SortLast.groups(8))
        assertEquals(listOf(2, 1), SortLast.groups(9))
        assertEquals(listOf(8, 1), SortLast.groups(64))
        assertEquals(listOf(9, 2, 1), SortLast.groups(65))
    }

    @Test
    fun eachBandOfAGroupHasATaskOfItsOwnIfThereAreEnough() {
        val (bands, groups) = 3 to 8
        val keys = (0 until bands).flatMap { band -> (0 until groups).map { BandKey(band, it) } }
        val tasks = SortLast.tasks(parts = 64, bands, groups)
        assertEquals((0 until 24).toList(), keys.map { SortLast.task(it, groups, tasks) }.sorted())

        // No more tasks than parts; the numbers of keys in them differ by one at most
        val few = SortLast.tasks(parts = 10, bands, groups)
        val loads = keys.groupingBy { SortLast.task(it, groups, few) }.eachCount()
        assertEquals(setOf(2, 3), loads.values.toSet())
        assertEquals(10, loads.size)
    }
}
