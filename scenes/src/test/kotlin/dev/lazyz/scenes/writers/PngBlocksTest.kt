package dev.lazyz.scenes.writers

import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.util.concurrent.Callable
import java.util.concurrent.ForkJoinPool
import javax.imageio.ImageIO
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class PngBlocksTest {
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun severalBlocksAreOnePicture() {
        for ((width, height) in listOf(300 to 1000, 1 to 200_000, 200_000 to 3, 65_537 to 2)) {
            val argb = argb(width, height)
            val back = ImageIO.read(ByteArrayInputStream(png(argb, width, height)))
            assertArrayEquals(argb, back.getRGB(0, 0, width, height, null, 0, width), "$width x $height")
        }
    }

    @Test
    fun bytesAreTheSameWhicheverThreadsCompress() {
        val (width, height) = 500 to 1500
        val argb = argb(width, height)
        val expected = zlib(argb, width, height)

        // One after the other, in this thread
        val alone = ByteArrayOutputStream()
        val rows = (1 shl 16) / width
        for (y in 0 until height step rows) {
            val count = minOf(rows, height - y)
            val block = IntArray((count + 1) * width)
            if (y > 0) System.arraycopy(argb, (y - 1) * width, block, 0, width)
            System.arraycopy(argb, y * width, block, width, count * width)
            alone.writeBytes(PngBlock(block, width, count, 4, y + count == height).invoke().bytes)
        }
        val middle = expected.copyOfRange(2, expected.size - 4)
        assertArrayEquals(alone.toByteArray(), middle)

        // By a thread of another pool, twice at the same time, and with all threads of the common pool busy
        val pool = ForkJoinPool(2)
        val busy = List(2 * ForkJoinPool.getCommonPoolParallelism()) {
            ForkJoinPool.commonPool().submit { Thread.sleep(100) }
        }
        val again = List(2) { pool.submit(Callable { zlib(argb, width, height) }) }
        for (bytes in again) assertArrayEquals(expected, bytes.get())
        busy.forEach { it.join() }
        pool.shutdown()
    }

    /** Areas of noise, of gradients and of one colour. */
    private fun argb(width: Int, height: Int): IntArray {
        val random = Random(width)
        return IntArray(width * height) {
            when (it / 10_000 % 3) {
                0 -> random.nextInt()
                1 -> it * 0x01020304
                else -> 0x7F112233
            }
        }
    }

    private fun zlib(argb: IntArray, width: Int, height: Int): ByteArray {
        val bytes = ByteArrayOutputStream()
        val blocks = PngBlocks(width, height, 4) { bytes.writeBytes(it) }
        for (y in 0 until height) blocks.add(argb.copyOfRange(y * width, (y + 1) * width))
        return bytes.toByteArray()
    }

    private fun png(argb: IntArray, width: Int, height: Int): ByteArray {
        val bytes = ByteArrayOutputStream()
        PngSink(bytes, width, height).use { sink ->
            val unused = IntArray(width)
            for (y in 0 until height) sink.row(y, argb.copyOfRange(y * width, (y + 1) * width), unused, unused)
        }
        return bytes.toByteArray()
    }
}
