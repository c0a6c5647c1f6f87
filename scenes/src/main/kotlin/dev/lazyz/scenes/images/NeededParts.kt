package dev.lazyz.scenes.images

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Takes from an image file only what its pixels need, so that decoders see nothing else. They may spend any amount of
 * memory and time on the rest, such as texts that are compressed, comments and colour profiles; and they would apply
 * profiles in floating point.
 */
internal object NeededParts {
    /**
     * Returns the parts of the PNG, JPEG, WebP, GIF or BMP file in [bytes] that its first image needs, or null if the
     * file is damaged, or would have a decoder read another kind of file. Files of other kinds are returned as they
     * are.
     */
    fun of(bytes: ByteArray): ByteArray? = when {
        NeededChunks.SIGNATURE.isAt(bytes, 0) -> NeededChunks.needed(bytes)
        JpegSegments.SIGNATURE.isAt(bytes, 0) -> JpegSegments.needed(bytes)
        WebPImage.isWebP(bytes) -> WebPImage.needed(bytes)
        GifBlocks.SIGNATURE.isAt(bytes, 0) -> GifBlocks.needed(bytes)
        BmpHeader.SIGNATURE.isAt(bytes, 0) -> BmpHeader.needed(bytes)
        else -> bytes
    }
}

/** Parts of an image file in order. Not thread safe. */
internal class FileParts(private val bytes: ByteArray) {
    private val kept = ByteArrayOutputStream(bytes.size)

    /** Keeps the bytes from [from] to [until] (exclusive), as far as they are there. */
    fun keep(from: Int, until: Int) = kept.write(bytes, from, minOf(until, bytes.size) - from)

    fun toByteArray(): ByteArray = kept.toByteArray()
}

/** Returns the byte at [index], 0..255, or -1 after the end. */
internal fun ByteArray.code(index: Int): Int = if (index < size) get(index).toInt() and 0xFF else -1

/** Whether [bytes] has these bytes from [start] on. */
internal fun ByteArray.isAt(bytes: ByteArray, start: Int): Boolean =
    start + size <= bytes.size && indices.all { this[it] == bytes[start + it] }

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

/** The blocks of a GIF file (CompuServe, "Graphics Interchange Format", version 89a). */
internal object GifBlocks {
    val SIGNATURE: ByteArray = "GIF8".toByteArray(Charsets.ISO_8859_1)

    private const val HEADER = 13
    private const val FLAGS = 10
    private const val EXTENSION = 0x21
    private const val CONTROL = 0xF9
    private const val IMAGE = 0x2C
    private const val IMAGE_HEADER = 10
    private const val TRAILER: Byte = 0x3B

    /** Returns the header and the first image, with the control block before it, which says what is transparent. */
    fun needed(bytes: ByteArray): ByteArray? {
        if (bytes.size < HEADER) return null
        val parts = FileParts(bytes)
        var at = HEADER + paletteSize(bytes.code(FLAGS))
        parts.keep(0, at)
        var control = 0 until 0
        while (bytes.code(at) == EXTENSION) {
            val end = blocksEnd(bytes, at + 2)
            if (bytes.code(at + 1) == CONTROL) control = at until end
            at = end
        }
        if (bytes.code(at) != IMAGE) return null
        if (!control.isEmpty()) parts.keep(control.first, control.last + 1)

        // The image: its header, its palette, the size of its codes, and blocks of data
        val data = at + IMAGE_HEADER + paletteSize(bytes.code(at + IMAGE_HEADER - 1)) + 1
        if (data > bytes.size) return null
        parts.keep(at, blocksEnd(bytes, data))
        return parts.toByteArray() + TRAILER
    }

    /** Returns the bytes of the palette that [flags] announce. */
    private fun paletteSize(flags: Int): Int = if (flags and 0x80 == 0) 0 else 3 shl (flags and 7) + 1

    /** Returns where the blocks at [from] end: behind an empty one, or at the end of the file. */
    private fun blocksEnd(bytes: ByteArray, from: Int): Int {
        var at = from
        while (bytes.code(at) > 0) at += 1 + bytes.code(at)
        return minOf(at + 1, bytes.size)
    }
}

/**
 * The segments of a JPEG file (ITU-T T.81, annex B): a marker, which is a byte of ones and a code, and for most codes a
 * length that includes its own two bytes. Compressed data follows the start of each scan.
 */
internal object JpegSegments {
    val SIGNATURE: ByteArray = byteArrayOf(0xFF.toByte(), 0xD8.toByte())

    private const val MARK = 0xFF
    private const val TEMPORARY = 0x01
    private const val EXTENSION = 0xC8
    private const val START_OF_SCAN = 0xDA
    private const val END_OF_IMAGE = 0xD9

    /** Frames and tables, restarts, scans, quantization, lines and restart intervals. */
    private val NEEDED = (0xC0..0xCF) - EXTENSION + (0xD0..0xD7) + (0xDA..0xDD)

    /** The application segments that say how colours are stored: their codes and names. */
    private val COLORS = mapOf(0xE0 to "JFIF\u0000", 0xEE to "Adobe").mapValues { (_, name) ->
        name.toByteArray(Charsets.ISO_8859_1)
    }

    /** Each scan can change the whole image; files of programs have some ten. */
    private const val MOST_SCANS = 100

    /** Returns the first image of the file without other segments, or null if it has too many scans. */
    fun needed(bytes: ByteArray): ByteArray? {
        val parts = FileParts(bytes)
        val colors = HashSet<Int>()
        var scans = 0
        var at = SIGNATURE.size
        parts.keep(0, at)
        while (true) {
            at = marker(bytes, at)
            if (at < 0) break
            val code = bytes.code(at + 1)
            if (code == END_OF_IMAGE) {
                parts.keep(at, at + 2)
                break
            }
            val isAlone = code in 0xD0..0xD7 || code == TEMPORARY
            val end = at + 2 + if (isAlone) 0 else maxOf(bytes.code(at + 2) shl 8 or bytes.code(at + 3), 2)
            val isColor = COLORS[code]?.isAt(bytes, at + 4) == true && colors.add(code)
            if (code in NEEDED || isColor) parts.keep(at, end)
            at = minOf(end, bytes.size)
            if (code == START_OF_SCAN) {
                if (++scans > MOST_SCANS) return null
                val next = dataEnd(bytes, at)
                parts.keep(at, next)
                at = next
            }
        }
        return parts.toByteArray()
    }

    /** Returns where the next marker begins at [from] or after it, or -1 if there is none. */
    private fun marker(bytes: ByteArray, from: Int): Int {
        for (at in from until bytes.size - 1) {
            if (bytes.code(at) == MARK && bytes.code(at + 1) != MARK && bytes.code(at + 1) != 0) return at
        }
        return -1
    }

    /** Returns where the compressed data at [from] ends: at a marker other than a restart. */
    private fun dataEnd(bytes: ByteArray, from: Int): Int {
        var at = from
        while (true) {
            at = marker(bytes, at)
            if (at < 0) return bytes.size
            if (bytes.code(at + 1) !in 0xD0..0xD7) return at
            at += 2
        }
    }
}

/** The chunks of a PNG file (W3C, "Portable Network Graphics", 3rd edition, section 5). */
internal object NeededChunks {
    val SIGNATURE: ByteArray = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)

    /** Header, palette, transparency, pixels and end. */
    private val NEEDED = listOf("IHDR", "PLTE", "tRNS", "IDAT", "IEND").map { it.toByteArray(Charsets.ISO_8859_1) }

    /** Bytes of a chunk besides its data: length, name and checksum. */
    private const val FRAME = 12L

    /** Returns the file without other chunks. */
    fun needed(bytes: ByteArray): ByteArray {
        val parts = FileParts(bytes)
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
