package dev.lazyz.scenes.writers

import java.io.OutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32

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
