package dev.lazyz.geometry

import dev.lazyz.shared.ProcessorTime
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class DistinctTriplesTest {
    @Test
    fun numbersAreThoseOfAMap() {
        val random = Random(1)
        for (expected in listOf(0, 1000, 100_000)) {
            val triples = DistinctTriples(expected)
            val map = HashMap<List<Int>, Int>()
            repeat(50_000) {
                val triple = List(3) { random.nextInt(30) - 15 }
                val number = map.getOrPut(triple) { map.size }
                assertEquals(number, triples.add(triple[0], triple[1], triple[2]))
                assertEquals(triple, List(3) { triples.get(number, it) })
            }
            assertEquals(map.size, triples.size)
        }
        assertThrows(IllegalArgumentException::class.java) { DistinctTriples(-1) }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun triplesThatCollideElsewhereAreFoundInLinearTime() {
        // All with the same hash code for 31 * (31 * a + b) + c; few bits that differ; all on one line
        val families = listOf<(Int) -> List<Int>>(
            { listOf(it, -31 * it, 0) },
            { listOf(0, it, -31 * it) },
            { listOf(it shl 16, 0, 0) },
            { listOf(it, it, it) },
            { listOf(0, 0, (it * 0.001f).toBits()) },
        )
        for (family in families) {
            var triples = DistinctTriples()
            ProcessorTime.assertLinear(160_000, { List(it, family) }) { all, _ ->
                triples = DistinctTriples()
                for ((a, b, c) in all) triples.add(a, b, c)
            }
            val seen = HashMap<List<Int>, Int>()
            for (i in 0 until 1000) seen.getOrPut(family(i)) { seen.size }
            for ((triple, number) in seen) assertEquals(number, triples.add(triple[0], triple[1], triple[2]))
        }
    }
}
