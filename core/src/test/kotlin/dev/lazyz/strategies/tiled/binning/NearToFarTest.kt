package dev.lazyz.strategies.tiled.binning

import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Keys are approximately sorted: those that are far apart by value, those that are close by order of arrival. */
class NearToFarTest {
    private fun sorted(keys: LongArray): List<Long> {
        val order = NearToFar()
        for (key in keys) order.add(key)
        order.sort()
        return List(order.count) { order[it] }
    }

    @Test
    fun keysThatDifferByFewBitsAreSorted() {
        val random = Random(1)
        for (count in listOf(1, 2, 63, 64, 65, 1000)) {
            val keys = LongArray(count) { (1L shl 62) + random.nextInt(256) }
            assertEquals(keys.sorted(), sorted(keys))
        }
        assertEquals(List(5) { 7L }, sorted(LongArray(5) { 7L }))
    }

    @Test
    fun keysThatAreFarApartAreInOrder() {
        val random = Random(2)
        for (bits in 9..63) {
            val keys = LongArray(500) { random.nextLong() ushr (64 - bits) }
            val order = sorted(keys)
            assertEquals(keys.sorted(), order.sorted())
            val bucket = (keys.max() - keys.min()) / 128 + 1
            var most = order.first()
            for (key in order) {
                assertTrue(key > most - bucket) { "$bits bits: $key behind $most" }
                most = maxOf(most, key)
            }
        }
    }

    @Test
    fun bytesAreThoseOfTheKeysTwiceAndOfTheBuckets() {
        val order = NearToFar()
        assertEquals(8L * 2 * 64 + 4 * 257, order.bytes)
        order.begin(1000)
        order.sort()
        assertEquals(8L * 2 * 1250 + 4 * 257, order.bytes)
    }

    @Test
    fun listsAreJoinedAndUsedAgain() {
        val random = Random(3)
        val all = NearToFar()
        var expected = emptyList<Long>()
        for (count in listOf(0, 10, 64, 200)) {
            val part = NearToFar()
            repeat(count) {
                val key = random.nextInt(256).toLong()
                part.add(key)
                expected = expected + key
            }
            all.addAll(part)
        }
        all.sort()
        assertEquals(expected.sorted(), List(all.count) { all[it] })

        for (count in listOf(2, 1000)) {
            val keys = all.begin(count)
            for (i in 0 until count) keys[i] = (count - i) % 256L
            all.sort()
            assertEquals(count, all.count)
            assertEquals(List(count) { (count - it) % 256L }.sorted(), List(count) { all[it] })
        }
    }
}
