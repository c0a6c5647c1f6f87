package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.SceneReadException
import java.io.EOFException
import java.io.IOException
import java.io.InputStream
import java.io.RandomAccessFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path

/**
 * Reads parts of a file, in any order. Thread safe. Unlike a channel, it stays open when a thread that reads is
 * interrupted.
 */
internal class FileBytes(path: Path, private val name: String) : AutoCloseable {
    private val file = RandomAccessFile(path.toFile(), "r")

    /** Number of bytes when the file was opened. */
    val size: Long = file.length()

    /**
     * Returns [count] bytes from [position] on, little endian.
     *
     * @throws SceneReadException if the file cannot be read, or has become shorter
     */
    fun read(position: Long, count: Int): ByteBuffer {
        val bytes = ByteArray(count)
        try {
            synchronized(file) {
                file.seek(position)
                file.readFully(bytes)
            }
        } catch (e: EOFException) {
            throw SceneReadException(name, "has become shorter while it was read", "render it again", e)
        } catch (e: IOException) {
            throw SceneReadException(name, "cannot be read: ${e.message ?: e}", cause = e)
        }
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
    }

    /** Returns the bytes from [position] on. The stream can be used until the file is closed. */
    fun stream(position: Long): InputStream = object : InputStream() {
        private var next = position

        override fun read(): Int {
            val byte = ByteArray(1)
            return if (read(byte, 0, 1) < 0) -1 else byte[0].toInt() and 0xFF
        }

        override fun read(bytes: ByteArray, offset: Int, length: Int): Int {
            val count = synchronized(file) {
                file.seek(next)
                file.read(bytes, offset, length)
            }
            if (count > 0) next += count
            return count
        }
    }

    override fun close() = file.close()
}
