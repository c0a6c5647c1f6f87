package dev.lazyz.scenes.writers

import dev.lazyz.RowSink
import java.io.Closeable
import java.io.IOException
import java.io.OutputStream

/**
 * Writes rows to a binary PPM stream (`P6`) as they arrive: red, green, blue, 8 bits each, sRGB.
 *
 * The format has no alpha. Alpha is dropped and the straight colours are written unchanged, so transparent black
 * becomes black. Memory: one row. [close] also closes the stream. Not thread safe.
 *
 * Source: the Netpbm project, "PPM Format Specification".
 *
 * @param output the target; the sink writes one row at a time
 * @param width number of columns; of a wider row, the first ones are written: arrays may be longer than rows, so that a
 *   sink does not see how wide a row is
 * @param height number of rows
 * @throws IllegalArgumentException if a side is not positive, or a row does not fit into memory
 * @throws IOException if the beginning of the file cannot be written
 */
public class PpmSink
@Throws(IOException::class)
constructor(
    private val output: OutputStream,
    private val width: Int,
    private val height: Int
) : RowSink,
    Closeable {
    private val bytes: ByteArray
    private val order = RowOrder(width, height)

    init {
        bytes = ByteArray(3 * width)
        output.write("P6\n$width $height\n255\n".toByteArray(Charsets.US_ASCII))
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
        for (x in 0 until width) {
            val color = argb[x]
            bytes[3 * x] = (color ushr 16).toByte()
            bytes[3 * x + 1] = (color ushr 8).toByte()
            bytes[3 * x + 2] = color.toByte()
        }
        output.write(bytes)
    }

    /**
     * Closes the stream. Closing again does nothing.
     *
     * @throws IOException if rows are missing, or writing to the stream fails; the stream is closed anyway
     */
    @Throws(IOException::class)
    override fun close(): Unit = order.close(output)

    override fun toString(): String = "PpmSink($width x $height, $order)"

    public companion object {
        /** Returns how many bytes a sink for so many columns holds. */
        @JvmStatic
        public fun memory(width: Int): Long = 3L * width
    }
}
