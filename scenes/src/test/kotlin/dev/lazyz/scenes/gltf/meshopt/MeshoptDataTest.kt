package dev.lazyz.scenes.gltf.meshopt

import java.nio.ByteBuffer
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class MeshoptDataTest {
    private fun elements(bytes: ByteArray, count: Int, stride: Int, filter: String = "NONE"): ByteBuffer =
        MeshoptData("ATTRIBUTES", filter, count, stride).decode(bytes)

    private fun ByteBuffer.bytes() = ByteArray(capacity()) { get(it) }

    /** Bytes that change in different ways, so that every width of difference appears. */
    private fun rows(count: Int, stride: Int) = ByteArray(count * stride) { i ->
        val e = i / stride
        val k = i % stride
        listOf(e * 3, e * e, e / 5, 7, e % 3 * 40, e * e * e, e and 1, k * e)[k % 8].toByte()
    }

    @Test
    fun attributesOfBothVersions() {
        assertArrayEquals(rows(300, 4), elements(MeshoptFixtures.version0Long, 300, 4).bytes())
        assertArrayEquals(rows(40, 16), elements(MeshoptFixtures.version0, 40, 16).bytes())
        assertArrayEquals(rows(40, 16), elements(MeshoptFixtures.version1, 40, 16).bytes())
    }

    @Test
    fun differencesOfPairsAndOfBits() {
        val elements = elements(MeshoptFixtures.version1Channels, 64, 12)
        for (e in 0 until 64) {
            assertEquals((e * 517).toShort(), elements.getShort(12 * e))
            assertEquals((60000 - e * 333).toShort(), elements.getShort(12 * e + 2))
            assertEquals(1f + e / 64f, elements.getFloat(12 * e + 4))
            assertEquals(100f - e * e * 0.25f, elements.getFloat(12 * e + 8))
        }
    }

    @Test
    fun exampleOfTheSpecification() {
        val group = listOf(0x17, 0x5f, 0xf0, 0xbc, 0x77, 0xa9, 0x21, 0x00, 0x34, 0xb5)
        val bytes = listOf(0xA0, 2) + group + List(3) { 0 } + List(32) { 0 }
        val elements = elements(ByteArray(bytes.size) { bytes[it].toByte() }, 16, 4)
        val deltas = listOf(-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0)
        val sums = deltas.runningReduce(Int::plus).map { it.toByte() }
        assertEquals(sums, (0 until 16).map { elements.get(4 * it) })
    }

    @Test
    fun trianglesOfSharedEdgesAndNewOnes() {
        val squares = (0 until 6).flatMap { y ->
            (0 until 6).flatMap { x ->
                val a = 7 * y + x
                listOf(a, a + 1, a + 7, a + 1, a + 8, a + 7)
            }
        } + listOf(100, 7, 3, 3, 7, 50, 60000, 1, 2)
        for (stride in listOf(2, 4)) {
            val data = MeshoptData("TRIANGLES", "NONE", squares.size, stride).decode(MeshoptFixtures.triangles)
            val indices = List(squares.size) {
                if (stride == 4) data.getInt(4 * it) else data.getShort(2 * it).toInt() and 0xFFFF
            }
            assertEquals(turned(squares), turned(indices))
        }
    }

    /** Triangles may begin with any of their corners. */
    private fun turned(indices: List<Int>) = indices.chunked(3).map { t ->
        val least = t.indexOf(t.min())
        listOf(t[least], t[(least + 1) % 3], t[(least + 2) % 3])
    }

    @Test
    fun indicesInAnyOrder() {
        val data = MeshoptData("INDICES", "NONE", 8, 4).decode(MeshoptFixtures.indices)
        assertEquals(listOf(0, 1000, 1, 1001, 2, 1002, 70000, 3), List(8) { data.getInt(4 * it) })
        val short = MeshoptData("INDICES", "NONE", 8, 2).decode(MeshoptFixtures.indices)
        assertEquals(70000.toShort(), short.getShort(12))
    }

    @Test
    fun whatIsImpossibleIsRefused() {
        val message = { mode: String, filter: String, count: Int, stride: Int ->
            assertThrows(MeshoptException::class.java) { MeshoptData(mode, filter, count, stride) }.message.orEmpty()
        }
        assertTrue("byteStride is 6" in message("ATTRIBUTES", "NONE", 1, 6))
        assertTrue("byteStride is 260" in message("ATTRIBUTES", "NONE", 1, 260))
        assertTrue("byteStride is 8" in message("INDICES", "NONE", 1, 8))
        assertTrue("byteStride is 3" in message("INDICES", "NONE", 1, 3))
        assertTrue("count is 4" in message("TRIANGLES", "NONE", 4, 2))
        assertTrue("count is -1" in message("INDICES", "NONE", -1, 2))
        assertTrue("mode is MAGIC" in message("MAGIC", "NONE", 1, 4))
        assertTrue("filter is MAGIC" in message("ATTRIBUTES", "MAGIC", 1, 4))
        assertTrue("filter is QUATERNION" in message("ATTRIBUTES", "QUATERNION", 1, 4))
        assertTrue("filter is COLOR" in message("INDICES", "COLOR", 1, 4))
    }

    @Test
    fun damageIsOneKindOfException() {
        val cases = listOf(
            Triple("ATTRIBUTES", 16, MeshoptFixtures.version0) to 40,
            Triple("ATTRIBUTES", 16, MeshoptFixtures.version1) to 40,
            Triple("ATTRIBUTES", 12, MeshoptFixtures.version1Channels) to 64,
            Triple("TRIANGLES", 4, MeshoptFixtures.triangles) to 225,
            Triple("INDICES", 2, MeshoptFixtures.indices) to 8,
        )
        for ((case, count) in cases) {
            val (mode, stride, good) = case
            val data = MeshoptData(mode, "NONE", count, stride)
            for (length in good.indices) {
                assertThrows(MeshoptException::class.java) { data.decode(good.copyOf(length)) }
            }
            for (at in good.indices) {
                for (change in listOf(1, 0x80, 0xFF)) {
                    val bad = good.copyOf().also { it[at] = (it[at].toInt() xor change).toByte() }
                    try {
                        data.decode(bad)
                    } catch (_: MeshoptException) {
                        // The one exception that is allowed
                    }
                }
            }
            assertThrows(MeshoptException::class.java) { data.decode(good + 0) }
        }
    }
}
