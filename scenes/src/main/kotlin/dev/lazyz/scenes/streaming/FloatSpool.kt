package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.writers.TemporaryFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.MappedByteBuffer
import java.nio.channels.FileChannel

/**
 * A temporary file of records of [width] numbers, which are read in any order after all have been written. The file is
 * mapped into memory in pieces: the operating system keeps what fits, and none of it is in the heap. Not thread safe.
 *
 * @param space where to create the file, and the room that it may take
 * @param width numbers of a record, 1..4
 * @param pieceBits logarithm of the records of a mapping, 2^30 bytes at most
 */
internal class FloatSpool(private val space: SpoolSpace, private val width: Int, private val pieceBits: Int = 26) :
    AutoCloseable {
    private val temporary = TemporaryFile.within(space.folder)
    private val buffer = ByteBuffer.allocate(BLOCK * width * Float.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN)
    private val mask = (1 shl pieceBits) - 1
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
        val piece = (1L shl pieceBits) * width * Float.SIZE_BYTES
        pieces = Array(((written + piece - 1) / piece).toInt()) { number ->
            val start = number * piece
            temporary.channel.map(FileChannel.MapMode.READ_ONLY, start, minOf(piece, written - start)).also {
                it.order(ByteOrder.LITTLE_ENDIAN)
            }
        }
    }

    /** Returns number [place] of [record]. */
    fun get(record: Int, place: Int): Float =
        pieces[record ushr pieceBits].getFloat(((record and mask) * width + place) * Float.SIZE_BYTES)

    /**
     * Deletes the file. Its space on the disk becomes free when the garbage collector has found that it is unused. Some
     * systems delete no file that is mapped; then it is deleted when the process exits, or by the next one.
     */
    override fun close() {
        pieces = emptyArray()
        temporary.close()
        space.release(written)
    }

    private companion object {
        /** Records that are written at a time. */
        const val BLOCK = 1 shl 14
    }
}
