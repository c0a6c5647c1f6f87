package dev.lazyz.scenes.writers

import dev.lazyz.RowSink
import java.io.ByteArrayOutputStream
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32

/** How an image file stores alpha. */
public enum class AlphaChannel {
    /** Alpha is written in addition to the colours, which stay straight (not premultiplied). */
    KEEP,

    /** Alpha is dropped. The straight colours are written unchanged, not composited over a background. */
    DROP,
}

/**
 * Writes rows to a PNG stream as they arrive: 8 bits per channel, sRGB.
 *
 * Blocks of rows are filtered and compressed in parallel on the threads of the common pool; the bytes are the same
 * for any number of threads. Memory: at most 17 blocks of 65,536 pixels, or of one row, whatever the height, so an
 * image can be larger than memory. For each row the sink chooses the filter that is likely to compress best (section
 * 12.8 of the specification). Does not need `java.desktop`. Call [close] after the last row, otherwise the file is
 * incomplete; it also closes the stream. Not thread safe.
 *
 * Source: "Portable Network Graphics (PNG) Specification", third edition, W3C.
 *
 * @param output the target; the sink buffers its writes, so the stream need not be buffered
 * @param width number of columns; of a wider row, the first ones are written: arrays may be longer than rows, so that a
 *   sink does not see how wide a row is
 * @param height number of rows
 * @param alpha whether the file has an alpha channel
 * @throws IllegalArgumentException if a side is not positive, or a row does not fit into memory
 * @throws IOException if the beginning of the file cannot be written
 */
public class PngSink
@JvmOverloads
@Throws(IOException::class)
constructor(
    private val output: OutputStream,
    private val width: Int,
    private val height: Int,
    private val alpha: AlphaChannel = AlphaChannel.KEEP,
) : RowSink,
    Closeable {
    private val chunks: PngChunks
    private val blocks: PngBlocks
    private val compressed = ByteArrayOutputStream()
    private val order = RowOrder(width, height)

    init {
        chunks = PngChunks(output)
        chunks.describe(width, height, alpha)
        blocks = PngBlocks(width, height, alpha.channels) { take(it) }
    }

    /**
     * Writes row [y]; depth and primitive are ignored.
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row (the first one may have any number from
     *   0 on), or the row has fewer than [width] columns
     * @throws IOException if writing to the stream fails
     */
    @Throws(IOException::class)
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        order.take(y, argb)
        blocks.add(argb)
    }

    /**
     * Writes the end of the file and closes the stream. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or writing to the stream fails; the stream is closed anyway
     */
    @Throws(IOException::class)
    override fun close(): Unit = order.close(output) {
        writeCompressed()
        chunks.write(PngChunks.END, ByteArray(0))
        output.flush()
    }

    override fun toString(): String = "PngSink($width x $height, $alpha, $order)"

    private fun take(data: ByteArray) {
        compressed.writeBytes(data)
        if (compressed.size() >= PngChunks.DATA_SIZE) writeCompressed()
    }

    private fun writeCompressed() {
        chunks.write(PngChunks.DATA, compressed.toByteArray())
        compressed.reset()
    }

    public companion object {
        /** Returns how many bytes a sink for so many columns and rows holds at most. */
        @JvmStatic
        public fun memory(width: Int, height: Int): Long = PngBlocks.bytes(width, height) + 2L * PngChunks.DATA_SIZE
    }
}

/** Writes chunks of a PNG file: length, type, data, and the checksum of type and data. */
internal class PngChunks(private val output: OutputStream) {
    /** Begins a file: writes the signature, and the chunks that describe an image of 8 bits per channel, sRGB. */
    fun describe(width: Int, height: Int, alpha: AlphaChannel) {
        header(width, height, depth = 8, if (alpha == AlphaChannel.KEEP) RGBA else RGB)
        write("sRGB", byteArrayOf(PERCEPTUAL))
    }

    /** Begins a file: writes the signature, and the header of an image with [depth] bits per channel, 8 or 16. */
    fun header(width: Int, height: Int, depth: Byte, colorType: Byte) {
        output.write(SIGNATURE)
        write("IHDR", ByteBuffer.allocate(13).putInt(width).putInt(height).put(depth).put(colorType).array())
    }

    fun write(type: String, data: ByteArray) {
        val name = type.toByteArray(Charsets.US_ASCII)
        val crc = CRC32().apply {
            update(name)
            update(data)
        }
        output.write(bigEndian(data.size))
        output.write(name)
        output.write(data)
        output.write(bigEndian(crc.value.toInt()))
    }

    private fun bigEndian(value: Int): ByteArray = ByteBuffer.allocate(Int.SIZE_BYTES).putInt(value).array()

    companion object {
        /** Bytes of compressed data that are collected for a chunk. */
        const val DATA_SIZE: Int = 1 shl 16

        /** The types of chunks of compressed data, and of the last chunk. */
        const val DATA: String = "IDAT"
        const val END: String = "IEND"

        const val GREY: Byte = 0
        const val RGB: Byte = 2
        const val RGBA: Byte = 6

        /** With these bytes a file begins; not to be changed. */
        val SIGNATURE: ByteArray = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)
        private const val PERCEPTUAL: Byte = 0
    }
}

/** Bytes of a pixel of a PNG file. */
internal val AlphaChannel.channels: Int get() = if (this == AlphaChannel.KEEP) 4 else 3
