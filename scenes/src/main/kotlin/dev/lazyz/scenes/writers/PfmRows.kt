package dev.lazyz.scenes.writers

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.SeekableByteChannel

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
