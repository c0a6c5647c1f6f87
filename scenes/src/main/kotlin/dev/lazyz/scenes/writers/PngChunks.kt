package dev.lazyz.scenes.writers

import java.io.OutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32

/** Writes the chunks of a PNG file to [output], after its signature. */
internal class PngChunks(private val output: OutputStream) {
    init {
        output.write(SIGNATURE)
    }

    /** Writes the header: an image with a bit [depth] of 8 or 16 and the given color type. */
    fun header(width: Int, height: Int, depth: Byte, colorType: Byte) {
        chunk("IHDR", ByteBuffer.allocate(13).putInt(width).putInt(height).put(depth).put(colorType).array())
    }

    /** Writes length, type, data, and the checksum of type and data. */
    fun chunk(type: String, data: ByteArray) {
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
        const val GREY: Byte = 0
        const val RGB: Byte = 2
        const val RGBA: Byte = 6

        private val SIGNATURE = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)
    }
}
