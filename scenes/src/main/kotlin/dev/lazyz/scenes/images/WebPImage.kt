package dev.lazyz.scenes.images

import com.sun.management.ThreadMXBean
import com.twelvemonkeys.imageio.plugins.webp.WebPImageReaderSpi
import java.lang.management.ManagementFactory
import java.nio.ByteBuffer
import java.nio.ByteOrder
import javax.imageio.IIOException
import javax.imageio.ImageReader
import javax.imageio.stream.ImageInputStreamImpl

/**
 * WebP files (Google, "WebP Container Specification"; RFC 9649), decoded by the library imageio-webp. Of an animation,
 * the first picture.
 */
internal object WebPImage {
    private const val CHUNK = 8
    private const val FILE_HEADER = 12
    private const val FRAME_HEADER = 16
    private const val EXTENDED_SIZE = 10
    private const val HAS_ALPHA = 0x10
    private const val SIDE_BITS = 0x3FFF
    private const val COMPRESSED_ALPHA = 1

    /** How many bytes the decoder reads ahead, and after how many it looks, less 1. */
    private const val AHEAD = 16
    private const val LOOK_EVERY = 0xFFL

    /** Bytes for tables of codes, of which encoders write some thousands, and for each pixel. */
    private const val MOST_TABLES = 32L shl 20
    private const val LOSSLESS_PIXEL = 12L
    private const val LOSSY_PIXEL = 96L

    /** The bytes at the start of each key frame, and of lossless data. */
    private val KEY_FRAME = byteArrayOf(0x9D.toByte(), 0x01, 0x2A)
    private const val LOSSLESS = 0x2F

    /** Whether [bytes] are a WebP file, whole or damaged. */
    fun isWebP(bytes: ByteArray): Boolean = name("RIFF").isAt(bytes, 0) && name("WEBP").isAt(bytes, CHUNK)

    /**
     * Returns the pixels and the alpha of the first picture as a file of their own, without colour profile and texts.
     * The size in its header is that of the compressed data, so nothing larger is decoded. Returns null if there is no
     * picture, or if its alpha is not compressed, which the decoder does not support.
     */
    fun needed(bytes: ByteArray): ByteArray? {
        val chunks = chunks(bytes, FILE_HEADER, bytes.size)
        val frame = chunks["ANMF"]
        val parts = if (frame == null) chunks else chunks(bytes, frame.first + FRAME_HEADER, frame.last + 1)
        val lossless = parts["VP8L"]
        if (lossless != null) {
            if (bytes.code(lossless.first) != LOSSLESS) return null
            return file(chunk("VP8L", bytes, lossless))
        }
        val lossy = parts["VP8 "] ?: return null
        val sides = lossy.first + 6
        if (lossy.count() < CHUNK + 2 || !KEY_FRAME.isAt(bytes, lossy.first + 3)) return null
        val alpha = parts["ALPH"] ?: return file(chunk("VP8 ", bytes, lossy))
        if (bytes.code(alpha.first) and 3 != COMPRESSED_ALPHA) return null

        // The extended header has 24 bits for each side less 1
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val width = (buffer.getShort(sides).toInt() and SIDE_BITS) - 1
        val height = (buffer.getShort(sides + 2).toInt() and SIDE_BITS) - 1
        val header = ByteBuffer.allocate(EXTENDED_SIZE).order(ByteOrder.LITTLE_ENDIAN)
            .putInt(HAS_ALPHA).putShort(width.toShort()).put(0).putShort(height.toShort()).put(0).array()
        return file(
            chunk("VP8X", header, header.indices) + chunk("ALPH", bytes, alpha) + chunk("VP8 ", bytes, lossy),
        )
    }

    /**
     * Returns a reader of the file that [needed] has returned, for this thread. [look] is called now and then while it
     * reads. A file whose tables of codes take more memory than those of any honest file is damaged.
     */
    fun reader(needed: ByteArray, look: () -> Unit): ImageReader {
        val most = allocated() + 2 * memory(needed)
        val stream = Bytes(needed) {
            look()
            if (allocated() > most) throw IIOException("the tables of codes are too large")
        }
        return WebPImageReaderSpi().createReaderInstance(null).apply { input = stream }
    }

    /** Returns the bytes that it takes to decode the file from [needed], at most. */
    fun memory(needed: ByteArray): Long =
        MOST_TABLES + pixels(needed) * if (name("VP8L").isAt(needed, FILE_HEADER)) LOSSLESS_PIXEL else LOSSY_PIXEL

    /** The number of pixels that the file says it has. */
    private fun pixels(needed: ByteArray): Long {
        val buffer = ByteBuffer.wrap(needed).order(ByteOrder.LITTLE_ENDIAN)
        val at = FILE_HEADER + CHUNK
        if (name("VP8L").isAt(needed, FILE_HEADER)) {
            val sides = buffer.getInt(at + 1)
            return (1L + (sides and SIDE_BITS)) * (1 + (sides ushr 14 and SIDE_BITS))
        }
        if (name("VP8X").isAt(needed, FILE_HEADER)) {
            return (1L + (buffer.getShort(at + 4).toInt() and 0xFFFF)) *
                (1 + (buffer.getShort(at + 7).toInt() and 0xFFFF))
        }
        return (buffer.getShort(at + 6).toLong() and SIDE_BITS.toLong()) *
            (buffer.getShort(at + 8).toInt() and SIDE_BITS)
    }

    /** Bytes that this thread has allocated so far, or 0 if this JVM does not count them. */
    private fun allocated(): Long = try {
        (ManagementFactory.getThreadMXBean() as? ThreadMXBean)?.getThreadAllocatedBytes(Thread.currentThread().id) ?: 0
    } catch (_: LinkageError) {
        0
    }

    /** Returns where the contents of the chunks from [from] on are, by their names; of several, the first. */
    private fun chunks(bytes: ByteArray, from: Int, until: Int): Map<String, IntRange> {
        val found = HashMap<String, IntRange>()
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        var at = from.toLong()
        while (at + CHUNK <= until) {
            val start = at.toInt() + CHUNK
            val length = Integer.toUnsignedLong(buffer.getInt(start - 4))
            val end = minOf(start + length, until.toLong()).toInt()
            if (end > start) found.putIfAbsent(String(bytes, start - CHUNK, 4, Charsets.ISO_8859_1), start until end)
            at = start + length + length % 2
        }
        return found
    }

    private fun chunk(name: String, bytes: ByteArray, range: IntRange): ByteArray {
        val size = range.count()
        val out = ByteBuffer.allocate(CHUNK + size + size % 2).order(ByteOrder.LITTLE_ENDIAN)
        return out.put(name(name)).putInt(size).put(bytes, range.first, size).array()
    }

    private fun file(chunks: ByteArray): ByteArray {
        val header = ByteBuffer.allocate(FILE_HEADER).order(ByteOrder.LITTLE_ENDIAN)
        return header.put(name("RIFF")).putInt(4 + chunks.size).put(name("WEBP")).array() + chunks
    }

    private fun name(text: String) = text.toByteArray(Charsets.ISO_8859_1)

    /**
     * Bytes as a stream that looks before each read whether to go on, because the decoder of lossless data has no
     * listeners. The decoder takes the end for any number of further bits, and reads a few bytes ahead; so some zeros
     * follow, and whoever reads on has a damaged file.
     */
    private class Bytes(private val bytes: ByteArray, private val look: () -> Unit) : ImageInputStreamImpl() {
        override fun read(): Int {
            checkClosed()
            bitOffset = 0
            if (streamPos and LOOK_EVERY == 0L) look()
            if (streamPos >= bytes.size + AHEAD) throw IIOException("the file is cut short")
            return maxOf(bytes.code(streamPos++.toInt()), 0)
        }

        override fun read(to: ByteArray, offset: Int, length: Int): Int {
            for (i in 0 until length) to[offset + i] = read().toByte()
            return length
        }

        override fun length(): Long = bytes.size.toLong()
    }
}
