package dev.lazyz.scenes.writers

import java.util.ArrayDeque
import java.util.concurrent.ForkJoinPool

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
