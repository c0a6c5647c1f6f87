package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.writers.TemporaryFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.MappedByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.StandardOpenOption.READ

/**
 * A temporary file of records of [width] numbers, which are read in any order after all have been written. The file is
 * mapped into memory in pieces: the operating system keeps what fits, and none of it is in the heap. Not thread safe.
 *
 * @param space where to create the file, and the room that it may take
 * @param width numbers of a record, 1..4
 */
internal class FloatSpool(private val space: SpoolSpace, private val width: Int) : AutoCloseable {
    private val temporary = TemporaryFile.within(space.folder)
    private val buffer = ByteBuffer.allocate(BLOCK * width * Float.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN)
    private var written = 0L
    private var pieces: Array<MappedByteBuffer> = emptyArray()

    /** Number of records. */
    val size: Int get() = ((written + buffer.position()) / (width * Float.SIZE_BYTES)).toInt()

    /** Adds the next number. */
    fun add(number: Float) {
        buffer.putFloat(number)
        if (!buffer.hasRemaining()) flush()
    }

    private fun flush() {
        buffer.flip()
        space.take(buffer.remaining().toLong())
        written += buffer.remaining()
        while (buffer.hasRemaining()) temporary.channel.write(buffer)
        buffer.clear()
    }

    /** Ends writing: from now on [get] works. */
    fun finish() {
        flush()
        val piece = PIECE.toLong() * width * Float.SIZE_BYTES
        FileChannel.open(temporary.path, READ).use { channel ->
            pieces = Array(((written + piece - 1) / piece).toInt()) { number ->
                val start = number * piece
                channel.map(FileChannel.MapMode.READ_ONLY, start, minOf(piece, written - start)).also {
                    it.order(ByteOrder.LITTLE_ENDIAN)
                }
            }
        }
    }

    /** Returns number [place] of [record]. */
    fun get(record: Int, place: Int): Float =
        pieces[record ushr PIECE_BITS].getFloat(((record and PIECE - 1) * width + place) * Float.SIZE_BYTES)

    /** Deletes the file. Its space on the disk becomes free when the garbage collector has found that it is unused. */
    override fun close() {
        pieces = emptyArray()
        temporary.close()
        space.release(written)
    }

    private companion object {
        /** Records that are written at a time. */
        const val BLOCK = 1 shl 14

        /** Records of a mapping: at most 2^30 bytes. */
        const val PIECE_BITS = 26
        const val PIECE = 1 shl PIECE_BITS
    }
}
