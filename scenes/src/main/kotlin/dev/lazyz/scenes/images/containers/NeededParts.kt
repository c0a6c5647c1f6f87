package dev.lazyz.scenes.images.containers

import java.io.ByteArrayOutputStream

/**
 * Takes from an image file only what its pixels need, so that decoders see nothing else. They may spend any amount of
 * memory and time on the rest, such as texts that are compressed, comments and colour profiles; and they would apply
 * profiles in floating point.
 */
internal object NeededParts {
    /**
     * Returns the parts of the PNG, JPEG, GIF or BMP file in [bytes] that its first image needs, or null if the file is
     * damaged, or would have a decoder read another kind of file. Files of other kinds are returned as they are.
     */
    fun of(bytes: ByteArray): ByteArray? = when {
        PngChunks.SIGNATURE.isAt(bytes, 0) -> PngChunks.needed(bytes)
        JpegSegments.SIGNATURE.isAt(bytes, 0) -> JpegSegments.needed(bytes)
        GifBlocks.SIGNATURE.isAt(bytes, 0) -> GifBlocks.needed(bytes)
        BmpHeader.SIGNATURE.isAt(bytes, 0) -> BmpHeader.needed(bytes)
        else -> bytes
    }
}

/** Parts of an image file in order. Not thread safe. */
internal class Parts(private val bytes: ByteArray) {
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
