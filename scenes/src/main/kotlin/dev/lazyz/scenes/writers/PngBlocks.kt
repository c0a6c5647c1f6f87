package dev.lazyz.scenes.writers

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.util.ArrayDeque
import java.util.concurrent.ForkJoinPool
import java.util.concurrent.RecursiveTask
import java.util.zip.Adler32
import java.util.zip.Deflater

/**
 * Collects rows into blocks, compresses the blocks on several threads, and writes the results in order.
 *
 * Memory: for each thread of the common pool two blocks of [BLOCK_PIXELS] pixels, or of one row, at most
 * [MOST_WAITING] blocks in total, plus one. Each block takes its colours and about as many bytes again.
 *
 * @param write receives the bytes of a zlib stream
 */
internal class PngBlocks(
    private val width: Int,
    private val height: Int,
    private val channels: Int,
    private val write: (ByteArray) -> Unit,
) {
    private val rowsOfBlock = rowsOfBlock(width, height)
    private var argb = IntArray(0)
    private var above = IntArray(width)
    private var rows = 0
    private var taken = 0
    private val waiting = ArrayDeque<PngBlock>()
    private val threads = threads()
    private val mostWaiting = mostWaiting()
    private val adler = AdlerSum()

    init {
        write(HEADER)
    }

    /** Adds the next row. */
    fun add(row: IntArray) {
        if (rows == 0) argb = above.copyOf((1 + rowsOfBlock.coerceAtMost(height - taken)) * width)
        System.arraycopy(row, 0, argb, (1 + rows) * width, width)
        rows++
        taken++
        if (rows == rowsOfBlock || taken == height) flush()
    }

    private fun flush() {
        val isLast = taken == height
        val block = PngBlock(argb, width, rows, channels, isLast)
        if (!isLast) System.arraycopy(argb, rows * width, above, 0, width)
        rows = 0
        waiting.add(block)

        // The calling thread also compresses if all other threads are busy or there are no more rows
        if (isLast || waiting.count { !it.isDone } > threads) block.invoke() else block.fork()
        while (waiting.isNotEmpty() && (isLast || waiting.peek().isDone || waiting.size > mostWaiting)) writeFirst()
        if (isLast) write(adler.toBytes())
    }

    private fun writeFirst() {
        val compressed = waiting.remove().join()
        adler.add(compressed.adler, compressed.length)
        write(compressed.bytes)
    }

    companion object {
        /** Small enough to keep several threads busy with a 512 x 512 image; makes the file 1 % larger. */
        private const val BLOCK_PIXELS = 1 shl 16
        private const val MOST_WAITING = 16

        /** Zlib header: deflate with a 32 KB window, fast compression; not to be changed. */
        val HEADER: ByteArray = byteArrayOf(0x78, 0x5E)

        private fun rowsOfBlock(width: Int, height: Int): Int = (BLOCK_PIXELS / width).coerceIn(1, height)

        private fun threads(): Int = ForkJoinPool.getCommonPoolParallelism().coerceAtMost(MOST_WAITING)

        private fun mostWaiting(): Int = (2 * threads()).coerceAtMost(MOST_WAITING)

        /** Bytes held at most: the blocks that wait and the next one, and what is compressed meanwhile. */
        fun bytes(width: Int, height: Int): Long {
            val colors = Int.SIZE_BYTES * (1L + rowsOfBlock(width, height)) * width
            return 2 * colors * (mostWaiting() + 1) + 2 * colors * (threads() + 1)
        }
    }
}

/**
 * Filters and compresses some rows of an image, on any thread.
 *
 * Blocks do not refer to each other's bytes. Therefore their compressed bytes, concatenated, are the same for any
 * assignment of blocks to threads.
 *
 * @param argb the rows in order, preceded by the row above the first one
 * @param rows number of rows, not counting the row above
 * @param isLast whether the compressed stream ends with this block
 */
internal class PngBlock(
    private val argb: IntArray,
    private val width: Int,
    private val rows: Int,
    private val channels: Int,
    private val isLast: Boolean,
) : RecursiveTask<PngBlock.Compressed>() {
    /**
     * Part of a deflate stream.
     *
     * @property adler checksum of the uncompressed bytes
     * @property length number of uncompressed bytes
     */
    class Compressed(val bytes: ByteArray, val adler: Int, val length: Int)

    override fun compute(): Compressed {
        val filtered = filter()
        val adler = Adler32().apply { update(filtered) }
        return Compressed(deflate(filtered), adler.value.toInt(), filtered.size)
    }

    private fun filter(): ByteArray {
        val filter = PngFilter(width, channels)
        val size = 1 + width * channels
        val filtered = ByteArray(rows * size)
        for (row in 0 until rows) filter.write(argb, (row + 1) * width, filtered, row * size)
        return filtered
    }

    private fun deflate(filtered: ByteArray): ByteArray {
        val deflater = Deflater(LEVEL, true)
        try {
            deflater.setInput(filtered)
            if (isLast) deflater.finish()
            val compressed = ByteArrayOutputStream()
            val buffer = ByteArray(BUFFER_SIZE)

            // The flush pads to a whole byte, so that the next block's bytes can follow
            val flush = if (isLast) Deflater.NO_FLUSH else Deflater.SYNC_FLUSH
            do {
                val count = deflater.deflate(buffer, 0, buffer.size, flush)
                compressed.write(buffer, 0, count)
            } while (if (isLast) !deflater.finished() else count == buffer.size)
            return compressed.toByteArray()
        } finally {
            deflater.end()
        }
    }

    private companion object {
        /** Takes about half the time of the default level 6; files of rendered images are about 3 % larger. */
        const val LEVEL = 5
        const val BUFFER_SIZE = 1 shl 15
    }
}

/**
 * The Adler-32 checksum of a stream, combined from the checksums of its parts.
 *
 * The checksum is two numbers modulo 65,521: 1 plus all bytes, and the sum of the first number's values after each
 * byte.
 *
 * Source: RFC 1950, section 9.
 */
internal class AdlerSum {
    private var bytes = 1L
    private var sums = 0L

    /** Appends a part of [length] bytes with the checksum [adler]. */
    fun add(adler: Int, length: Int) {
        val ofPart = adler and 0xFFFF

        // The part's first sums start at 1, but here they start at the value before the part
        sums = (sums + (adler ushr 16) + length % MODULUS * (bytes + MODULUS - 1)) % MODULUS
        bytes = (bytes + ofPart + MODULUS - 1) % MODULUS
    }

    /** Returns the checksum as it is stored at the end of a zlib stream. */
    fun toBytes(): ByteArray = ByteBuffer.allocate(Int.SIZE_BYTES).putInt((sums shl 16 or bytes).toInt()).array()

    private companion object {
        const val MODULUS = 65_521L
    }
}
