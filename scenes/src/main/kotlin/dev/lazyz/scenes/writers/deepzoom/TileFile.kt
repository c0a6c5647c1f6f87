package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.AdlerSum
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.PngBlock
import dev.lazyz.scenes.writers.PngBlocks
import dev.lazyz.scenes.writers.PngChunks
import dev.lazyz.scenes.writers.PngFilter
import dev.lazyz.scenes.writers.channels
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import java.util.zip.DataFormatException
import java.util.zip.Inflater

/**
 * A tile, a PNG file, to which blocks of rows are appended. It has its name only when it is complete, and is closed
 * between blocks: there are more tiles side by side than a process can have open files.
 */
internal class TileFile(
    private val path: Path,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel,
) {
    private val partial = path.resolveSibling("${path.fileName}.part")
    private val adler = AdlerSum()
    private var rows = 0

    /**
     * Compresses and appends the next [count] rows. [argb] begins with the row above them.
     *
     * @throws UncheckedIOException if the file cannot be written
     */
    fun append(argb: IntArray, count: Int) {
        val isFirst = rows == 0
        rows += count
        val isLast = rows == height
        val block = PngBlock(argb, width, count, alpha.channels, isLast).invoke()
        adler.add(block.adler, block.length)
        try {
            val bytes = bytes(block.bytes, isFirst, isLast)
            Files.write(partial, bytes, CREATE, WRITE, if (isFirst) TRUNCATE_EXISTING else APPEND)
            if (isLast) Files.move(partial, path, REPLACE_EXISTING)
        } catch (e: IOException) {
            // The tiles of a level are written by a parallel stream
            throw UncheckedIOException(e)
        }
    }

    private fun bytes(compressed: ByteArray, isFirst: Boolean, isLast: Boolean): ByteArray {
        val bytes = ByteArrayOutputStream(compressed.size + ROOM)
        val chunks = PngChunks(bytes)
        if (isFirst) chunks.describe(width, height, alpha)
        val before = if (isFirst) PngBlocks.HEADER else ByteArray(0)
        val after = if (isLast) adler.toBytes() else ByteArray(0)
        chunks.write(PngChunks.DATA, before + compressed + after)
        if (isLast) chunks.write(PngChunks.END, ByteArray(0))
        return bytes.toByteArray()
    }

    companion object {
        /** For all but the compressed bytes. */
        private const val ROOM = 128

        private val END: ByteArray = ByteArrayOutputStream().apply {
            PngChunks(this).write(PngChunks.END, ByteArray(0))
        }.toByteArray()

        /** Whether [path] is a file that ends like a PNG file. After a power failure it can be empty or truncated. */
        fun isWhole(path: Path): Boolean {
            if (!Files.exists(path)) return false
            return FileChannel.open(path).use { file ->
                val end = ByteBuffer.allocate(END.size)
                file.size() > END.size && file.read(end, file.size() - END.size) == END.size &&
                    end.array().contentEquals(END)
            }
        }
    }
}

/**
 * Reads a tile that [TileFile] has written, row by row. The file is closed between parts of [PART] bytes, for the same
 * reason as there. Memory: the state of the decompression, about 40 KB, and two rows.
 */
internal class TileReader(private val path: Path, private val width: Int, alpha: AlphaChannel) : AutoCloseable {
    private val channels = alpha.channels
    private val inflater = Inflater()
    private val filtered = ByteArray(1 + width * channels)
    private val filter = PngFilter(width, channels)
    private val row = IntArray(width)

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
        if (!filter.restore(filtered, row)) throw damaged()
        System.arraycopy(row, 0, argb, 0, width)
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
