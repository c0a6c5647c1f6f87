package dev.lazyz.server.render

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class UploadTest {
    private val budget = MemoryBudget(1 shl 20)

    private fun Upload.add(bytes: ByteArray) {
        var from = 0
        add(bytes.size) { array, at, count ->
            bytes.copyInto(array, at, from, from + count)
            from += count
        }
    }

    @Test
    fun bytesArriveInTheirOrder() {
        val all = ByteArray(100_000) { it.toByte() }
        for (announced in listOf(null, all.size.toLong())) {
            val upload = Upload(announced, 200_000, budget)
            for (start in all.indices step 777) upload.add(all.copyOfRange(start, minOf(start + 777, all.size)))
            assertArrayEquals(all, upload.joined())
            assertArrayEquals(all.copyOf(1 shl 14), upload.start())
            assertTrue(budget.used in all.size..2 * all.size) { "${budget.used}" }
            repeat(2) { upload.release() }
            assertEquals(0, budget.used)
        }
    }

    @Test
    fun onlyWhatArrivesTakesMemory() {
        val upload = Upload(1_000_000, 1_000_000, budget)
        upload.add(ByteArray(10))
        assertEquals(1L shl 14, budget.used)
    }

    @Test
    fun whatIsTooLargeIsRefused() {
        assertEquals(413, assertThrows(Problem::class.java) { Upload(11, 10, budget) }.status)
        val upload = Upload(null, 10, budget)
        upload.add(ByteArray(10))
        assertEquals(413, assertThrows(Problem::class.java) { upload.add(ByteArray(1)) }.status)
        val other = Upload(null, 1 shl 21, budget)
        assertEquals(503, assertThrows(Problem::class.java) { other.add(ByteArray(1 shl 20)) }.status)
        other.release()
        assertEquals(10, budget.used)
    }
}
