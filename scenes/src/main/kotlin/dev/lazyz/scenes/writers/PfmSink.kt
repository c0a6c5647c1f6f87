package dev.lazyz.scenes.writers

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.RowSink
import java.io.Closeable
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.SeekableByteChannel

/**
 * Writes the depth of rows to a portable float map (`Pf`): one 32-bit number per pixel, little endian.
 *
 * A number is [Depth.toUnit] of the stored depth: 0 at the near plane, 1 at the far plane (or the reverse in a frame
 * whose larger depths are nearer), linear in screen space. A float keeps the upper 24 of the 31 bits. Where no
 * primitive is visible the number is +Infinity, which no primitive's depth ever is.
 *
 * The format stores the bottom row first, but rows arrive from the top. Therefore the sink writes backwards and needs
 * a seekable channel, such as that of a file. Memory: one row. [close] also closes the channel. Not thread safe.
 *
 * Source: Paul Debevec, "PFM Portable FloatMap Image Format"; the Netpbm project, "pfm".
 *
 * @param output the target; the file starts at the channel's current position
 * @param width number of columns; of a wider row, the first ones are written: arrays may be longer than rows, so that a
 *   sink does not see how wide a row is
 * @param height number of rows
 * @throws IllegalArgumentException if a side is not positive, or a row does not fit into memory
 * @throws IOException if the beginning of the file cannot be written
 */
public class PfmSink
@Throws(IOException::class)
constructor(
    private val output: SeekableByteChannel,
    private val width: Int,
    private val height: Int
) : RowSink,
    Closeable {
    private val rows: PfmRows
    private val order = RowOrder(width, height)

    init {
        rows = PfmRows(output, width, height, channels = 1)
    }

    /**
     * Writes row [y]; colours are ignored.
     *
     * @throws IllegalArgumentException if [y] does not follow the previous row (the first one may have any number from
     *   0 on), or the row has fewer than [width] columns
     * @throws IOException if writing to the channel fails
     */
    @Throws(IOException::class)
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        order.take(y, primitive)
        rows.write(order.taken - 1) { x ->
            val isCovered = primitive[x] != DepthTest.BACKGROUND
            if (isCovered) Depth.toUnit(depth[x]).toFloat() else Float.POSITIVE_INFINITY
        }
    }

    /**
     * Closes the channel. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or writing to the channel fails; the channel is closed anyway
     */
    @Throws(IOException::class)
    override fun close(): Unit = order.close(output)

    override fun toString(): String = "PfmSink($width x $height, $order)"

    public companion object {
        /** Returns how many bytes a sink for so many columns holds. */
        @JvmStatic
        public fun memory(width: Int): Long = PfmRows.bytes(width, 1)
    }
}

/**
 * Writes a portable float map: the header at once, then rows of numbers in any order. The format has the bottom row
 * first. Numbers are little endian.
 *
 * @param output the target; the file starts at the channel's current position
 * @param channels numbers for each pixel, 1 (`Pf`) or 3 (`PF`)
 */
internal class PfmRows(private val output: SeekableByteChannel, width: Int, private val height: Int, channels: Int) {
    private val numbers = width * channels
    private val bytes = ByteBuffer.allocate(Float.SIZE_BYTES * numbers).order(ByteOrder.LITTLE_ENDIAN)
    private val start: Long

    init {
        val type = if (channels == 1) "Pf" else "PF"
        val header = ByteBuffer.wrap("$type\n$width $height\n-1.0\n".toByteArray(Charsets.US_ASCII))
        while (header.hasRemaining()) output.write(header)
        start = output.position()
    }

    /** Writes row [row], counted from the top from 0. [number] returns the numbers of the row by their index. */
    fun write(row: Int, number: (Int) -> Float) {
        bytes.clear()
        for (i in 0 until numbers) bytes.putFloat(number(i))
        bytes.flip()
        output.position(start + (height - 1L - row) * Float.SIZE_BYTES * numbers)
        while (bytes.hasRemaining()) output.write(bytes)
    }

    companion object {
        /** Bytes held for a row. */
        fun bytes(width: Int, channels: Int): Long = Float.SIZE_BYTES.toLong() * width * channels
    }
}
