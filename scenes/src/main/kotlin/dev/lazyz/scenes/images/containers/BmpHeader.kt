package dev.lazyz.scenes.images.containers

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** The header of a BMP file (Microsoft, "Bitmap Storage": `BITMAPFILEHEADER` and the headers that follow it). */
internal object BmpHeader {
    val SIGNATURE: ByteArray = "BM".toByteArray(Charsets.ISO_8859_1)

    private const val FILE_SIZE = 2
    private const val PIXELS = 10
    private const val HEADER_SIZE = 14
    private const val COMPRESSION = 30
    private const val IMAGE_SIZE = 34
    private const val COLOR_SPACE = 70

    /** The smallest header with a compression, and the one with a colour space. */
    private const val USUAL = 40
    private const val VERSION_4 = 108

    /** Whole files of other formats as pixels. */
    private val FILES = 4..5
    private const val SRGB = 0x73524742

    /**
     * Returns the file without a colour profile, and without sizes that are larger than the file, for which decoders
     * reserve memory. Returns null if the header is damaged, or if the pixels are a file of another format.
     */
    fun needed(bytes: ByteArray): ByteArray? {
        if (bytes.size < HEADER_SIZE + 4) return null
        val buffer = ByteBuffer.wrap(bytes.copyOf()).order(ByteOrder.LITTLE_ENDIAN)
        val header = buffer.getInt(HEADER_SIZE)
        val pixels = buffer.getInt(PIXELS)
        if (header !in 0..bytes.size - HEADER_SIZE || pixels !in 0..bytes.size) return null
        limit(buffer, FILE_SIZE, bytes.size)
        if (header >= USUAL) {
            if (buffer.getInt(COMPRESSION) in FILES) return null
            limit(buffer, IMAGE_SIZE, bytes.size - pixels)
        }
        if (header >= VERSION_4) buffer.putInt(COLOR_SPACE, SRGB)
        return buffer.array()
    }

    /** Makes the unsigned number at [at] at most [most]. */
    private fun limit(buffer: ByteBuffer, at: Int, most: Int) {
        if (Integer.toUnsignedLong(buffer.getInt(at)) > most) buffer.putInt(at, most)
    }
}
