package dev.lazyz.scenes.writers

import dev.lazyz.RowSink
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32
import java.util.zip.Deflater

/** What an image file does with alpha. */
public enum class AlphaChannel {
    /** Alpha is written beside the colours, which stay straight (not premultiplied). */
    KEEP,

    /** Alpha is dropped; the straight colours are written as they are, not composited over anything. */
    DROP,
}

/**
 * Writes rows to a PNG stream as they come: 8 bits a channel, sRGB.
 *
 * Holds two rows and the compressor, whatever the height, so a picture may be larger than memory; each row is filtered
 * by the heuristic of the specification (section 12.8: least sum of absolute differences of the five filters). Needs no
 * `java.desktop`. [close] after the last row, or the file is cut off; it closes the stream too. Not thread safe.
 *
 * Source: "Portable Network Graphics (PNG) Specification", third edition, W3C.
 *
 * @param output where to; buffered here, so it need not be
 * @param width number of columns
 * @param height number of rows
 * @param alpha whether the file has an alpha channel
 * @throws IllegalArgumentException if a side is not positive, or a row does not fit into memory
 */
public class PngSink @JvmOverloads constructor(
    private val output: OutputStream,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel = AlphaChannel.KEEP,
) : RowSink,
    Closeable {
    private val channels = if (alpha == AlphaChannel.KEEP) 4 else 3
    private val filter: PngFilter
    private val deflater = Deflater()
    private val compressed = ByteArray(CHUNK_SIZE)
    private var filled = 0
    private val order = RowOrder(height)
    private var isClosed = false

    init {
        require(width > 0 && height > 0) { "an image must have at least one pixel: $width x $height" }
        require(width <= MAX_WIDTH) { "width must be at most $MAX_WIDTH: $width" }
        filter = PngFilter(width, channels)
        output.write(SIGNATURE)
        val colorType = if (alpha == AlphaChannel.KEEP) COLOR_TYPE_RGBA else COLOR_TYPE_RGB
        val header = ByteBuffer.allocate(13).putInt(width).putInt(height).put(8).put(colorType)
        chunk("IHDR", header.array(), 13)
        chunk("sRGB", byteArrayOf(PERCEPTUAL), 1)
    }

    /**
     * Writes row [y]; depth and primitive are ignored.
     *
     * @throws IllegalArgumentException if it is not the row after the last one; the first may have any number
     * @throws IOException if the stream does not take it
     */
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        order.take(y)
        filter.load(argb)
        deflater.setInput(filter.best())
        while (!deflater.needsInput()) compress()
    }

    /**
     * Writes the end of the file and closes the stream. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or the stream does not take it; the stream is closed all the same
     */
    override fun close() {
        if (isClosed) return
        isClosed = true
        output.use {
            try {
                order.requireComplete()
                deflater.finish()
                while (!deflater.finished()) compress()
                if (filled > 0) flush()
                chunk("IEND", compressed, 0)
                output.flush()
            } finally {
                deflater.end()
            }
        }
    }

    override fun toString(): String = "PngSink($width x $height, $alpha, $order)"

    private fun compress() {
        filled += deflater.deflate(compressed, filled, compressed.size - filled)
        if (filled == compressed.size) flush()
    }

    private fun flush() {
        chunk("IDAT", compressed, filled)
        filled = 0
    }

    /** Writes length, type, data, and the check sum of type and data. */
    private fun chunk(type: String, data: ByteArray, size: Int) {
        val name = type.toByteArray(Charsets.US_ASCII)
        val crc = CRC32().apply {
            update(name)
            update(data, 0, size)
        }
        output.write(bigEndian(size))
        output.write(name)
        output.write(data, 0, size)
        output.write(bigEndian(crc.value.toInt()))
    }

    private fun bigEndian(value: Int): ByteArray = ByteBuffer.allocate(4).putInt(value).array()

    private companion object {
        const val CHUNK_SIZE = 1 shl 16
        const val MAX_WIDTH = 1 shl 28
        const val COLOR_TYPE_RGB: Byte = 2
        const val COLOR_TYPE_RGBA: Byte = 6
        const val PERCEPTUAL: Byte = 0
        val SIGNATURE = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)
    }
}
