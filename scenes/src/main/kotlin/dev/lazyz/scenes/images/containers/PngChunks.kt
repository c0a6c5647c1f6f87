package dev.lazyz.scenes.images.containers

import java.nio.ByteBuffer

/** The chunks of a PNG file (W3C, "Portable Network Graphics", 3rd edition, section 5). */
internal object PngChunks {
    val SIGNATURE: ByteArray = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)

    /** Header, palette, transparency, pixels and end. */
    private val NEEDED = listOf("IHDR", "PLTE", "tRNS", "IDAT", "IEND").map { it.toByteArray(Charsets.ISO_8859_1) }

    /** Bytes of a chunk besides its data: length, name and checksum. */
    private const val FRAME = 12L

    /** Returns the file without other chunks. */
    fun needed(bytes: ByteArray): ByteArray {
        val parts = Parts(bytes)
        val buffer = ByteBuffer.wrap(bytes)
        parts.keep(0, SIGNATURE.size)
        var at = SIGNATURE.size
        while (at + FRAME <= bytes.size) {
            val length = buffer.getInt(at)
            if (length < 0) break
            val end = minOf(at + FRAME + length, bytes.size.toLong()).toInt()
            val kind = NEEDED.indexOfFirst { it.isAt(bytes, at + 4) }
            if (kind >= 0) parts.keep(at, end)
            if (kind == NEEDED.size - 1) break
            at = end
        }
        return parts.toByteArray()
    }
}
