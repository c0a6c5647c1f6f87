package dev.lazyz.scenes.streaming

import java.io.EOFException
import java.io.RandomAccessFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path

/**
 * Reads parts of a file, in any order. Thread safe. Unlike a channel, it stays open when a thread that reads is
 * interrupted.
 */
internal class FileBytes(path: Path) : AutoCloseable {
    private val file = RandomAccessFile(path.toFile(), "r")

    /** Number of bytes when the file was opened. */
    val size: Long = file.length()

    /**
     * Returns [count] bytes from [position] on, little endian.
     *
     * @throws EOFException if the file has become shorter
     */
    fun read(position: Long, count: Int): ByteBuffer {
        val bytes = ByteArray(count)
        synchronized(file) {
            file.seek(position)
            file.readFully(bytes)
        }
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
    }

    override fun close() = file.close()
}
