package dev.lazyz.scenes.images

import java.io.IOException
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Files that the program `zstd` has written, with levels of compression from 1 to 19. */
class ZstandardTest {
    private fun file(name: String) = checkNotNull(javaClass.getResource("$name.zst")).readBytes()

    private fun decoded(bytes: ByteArray, size: Int, look: () -> Unit = {}): ByteArray =
        Zstandard.decode(bytes, 0, bytes.size, size, look)

    /** Bytes of which small ones are frequent. */
    private val short: ByteArray by lazy {
        var x = 1
        ByteArray(1500) {
            x = x * 1103515245 + 12345
            ((x shr 16 and 15) * (x shr 20 and 15) shr 2).toByte()
        }
    }

    /** Pieces of [short] at many distances. */
    private val long: ByteArray by lazy {
        ByteArray(150_000) {
            if (it % 20_000 > 300) {
                short[(it + it / 90 * 37 + it / 5000 * 11) % 1500]
            } else {
                (it.toLong() * it shr 3).toByte()
            }
        }
    }

    @Test
    fun allKindsOfBlocksAreDecoded() {
        assertArrayEquals(short, decoded(file("short"), short.size))
        assertArrayEquals(ByteArray(200_000), decoded(file("zero"), 200_000))
        for (level in listOf(1, 19)) assertArrayEquals(long, decoded(file("long-$level"), long.size), "$level")
    }

    @Test
    fun framesFollowEachOther() {
        val skipped = byteArrayOf(0x53, 0x2A, 0x4D, 0x18, 2, 0, 0, 0, 9, 9)
        assertArrayEquals(short + short, decoded(file("short") + skipped + file("short"), 2 * short.size))
    }

    /** The last four bytes are a checksum, which is not compared. */
    @Test
    fun damageAndWrongSizesAreFound() {
        val bytes = file("short")
        for (size in listOf(short.size - 1, short.size + 1)) {
            assertThrows(Exception::class.java, { decoded(bytes, size) }, "$size")
        }
        var found = 0
        for (at in bytes.indices) {
            if (at < bytes.size - 4) assertThrows(Exception::class.java) { decoded(bytes.copyOf(at), short.size) }
            val broken = bytes.copyOf().also { it[at] = (it[at].toInt() xor 0x55).toByte() }
            try {
                if (!decoded(broken, short.size).contentEquals(short)) found++
            } catch (_: IOException) {
                found++
            } catch (_: IndexOutOfBoundsException) {
                found++
            }
        }
        assertTrue(found > bytes.size / 2, "$found of ${bytes.size}")
    }

    @Test
    fun theDecodingCanBeEnded() {
        var looks = 0
        decoded(file("long-1"), long.size) { looks++ }
        assertEquals(2, looks)
        assertThrows(IllegalStateException::class.java) { decoded(file("long-1"), long.size) { error("enough") } }
    }
}
