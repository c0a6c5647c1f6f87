package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.PngChunks
import dev.lazyz.scenes.writers.PngFilter
import dev.lazyz.scenes.writers.channels
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.READ
import java.util.zip.DataFormatException
import java.util.zip.Inflater

/**
 * Reads a tile that [TileFile] has written, row by row. The file is closed between parts of [PART] bytes, for the same
 * reason as there. Memory: the state of the decompression, about 40 KB, and two rows.
 */
internal class TileReader(private val path: Path, private val width: Int, alpha: AlphaChannel) : AutoCloseable {
    private val channels = alpha.channels
    private val inflater = Inflater()
    private val filtered = ByteArray(1 + width * channels)
    private val filter = PngFilter(width, channels)

    /** The next byte of the file, and the number of bytes that the current chunk of data still has. */
    private var position = PngChunks.SIGNATURE.size.toLong()
    private var left = 0

    /**
     * Reads the next row into [argb].
     *
     * @throws IOException if the file is damaged or cannot be read
     */
    fun read(argb: IntArray) {
        var at = 0
        while (at < filtered.size) {
            if (inflater.needsInput()) inflater.setInput(part())
            try {
                at += inflater.inflate(filtered, at, filtered.size - at)
            } catch (_: DataFormatException) {
                throw damaged()
            }
            if (at < filtered.size && (inflater.finished() || inflater.needsDictionary())) throw damaged()
        }
        if (!filter.restore(filtered, argb)) throw damaged()
    }

    override fun close() = inflater.end()

    /** Reads the next part of the compressed data. */
    private fun part(): ByteArray = FileChannel.open(path, READ).use { file ->
        while (left == 0) {
            val head = bytes(file, LENGTH_AND_TYPE)
            val length = head.getInt()
            val type = Charsets.US_ASCII.decode(head).toString()
            if (length < 0 || type == PngChunks.END) throw damaged()
            if (type == PngChunks.DATA) left = length else position += length + CHECKSUM
        }
        val count = minOf(left, PART)
        val part = bytes(file, count).array()
        left -= count
        if (left == 0) position += CHECKSUM
        part
    }

    private fun bytes(file: FileChannel, count: Int): ByteBuffer {
        val bytes = ByteBuffer.allocate(count)
        while (bytes.hasRemaining()) {
            val read = file.read(bytes, position)
            if (read < 0) throw damaged()
            position += read
        }
        return bytes.flip()
    }

    private fun damaged() = IOException("the tile $path is damaged")

    private companion object {
        const val PART = 1 shl 14
        const val LENGTH_AND_TYPE = 8
        const val CHECKSUM = 4L
    }
}
