package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.writers.TemporaryFile
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.IntBuffer
import java.nio.channels.FileChannel
import java.nio.channels.FileChannel.MapMode.READ_ONLY
import java.nio.file.Path
import java.nio.file.StandardOpenOption.READ

/**
 * A growing list of 32-bit words in a temporary file, which is mapped into memory: words are read in any order from the
 * pages that the operating system keeps. On the heap there are 4 MiB, those that were added last.
 *
 * One thread adds words. After the last one, all threads can read.
 *
 * @param folder where to create the file
 */
internal class WordSpool(folder: Path) : AutoCloseable {
    private val temporary = TemporaryFile.within(folder)
    private val reading = FileChannel.open(temporary.path, READ)
    private val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * PIECE).order(ByteOrder.nativeOrder())
    private val last: IntBuffer = bytes.asIntBuffer()

    /** The pieces in the file. */
    private val pieces = ArrayList<IntBuffer>()

    /** Number of words. */
    val size: Long get() = PIECE.toLong() * pieces.size + last.position()

    fun add(word: Int) {
        last.put(word)
        if (!last.hasRemaining()) flush()
    }

    private fun flush() {
        bytes.clear()
        while (bytes.hasRemaining()) temporary.channel.write(bytes)
        val length = bytes.capacity().toLong()
        pieces += reading.map(READ_ONLY, pieces.size * length, length).order(ByteOrder.nativeOrder()).asIntBuffer()
        last.clear()
    }

    /** Returns word [at], which must have been added. */
    operator fun get(at: Long): Int {
        val piece = (at shr PIECE_BITS).toInt()
        val words = if (piece < pieces.size) pieces[piece] else last
        return words.get((at and PIECE - 1L).toInt())
    }

    /** Deletes the file. */
    override fun close() {
        reading.close()
        try {
            temporary.close()
        } catch (_: IOException) {
            // Some systems do not delete files that are mapped. The next process that writes to the folder deletes it
        }
    }

    private companion object {
        /** Words of a piece. */
        const val PIECE_BITS = 20
        const val PIECE = 1 shl PIECE_BITS
    }
}
