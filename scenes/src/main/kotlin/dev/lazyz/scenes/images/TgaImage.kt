package dev.lazyz.scenes.images

import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.IOException

/**
 * A Truevision TGA file (Truevision, "TGA File Format Specification", version 2.0, 1991): colours of 15 to 32 bits,
 * grey or colour-mapped, with or without run-length encoding.
 *
 * Alpha counts if the header says that pixels have alpha bits, unless all of them are 0: some programs write it so for
 * opaque pictures. The format has no signature, so [of] checks all that the header says.
 */
internal class TgaImage private constructor(private val bytes: ByteArray) {
    private val kind = byte(2) and PACKED.inv()
    private val isPacked = byte(2) and PACKED != 0
    private val width = short(12)
    private val height = short(14)
    private val depth = byte(16)
    private val descriptor = byte(17)

    /** The colour map: number of its first colour, number of colours, and bits of each. */
    private val mapFirst = short(3)
    private val mapLength = short(5)
    private val mapDepth = byte(7)
    private val mapStart = HEADER + byte(0)
    private val start = mapStart + (if (byte(1) == 1) mapLength * bytesOf(mapDepth) else 0)

    /** Number of pixels. */
    val pixels: Long get() = width.toLong() * height

    private fun isValid(): Boolean {
        val isKnown = when (kind) {
            MAPPED -> byte(1) == 1 && (depth == 8 || depth == 16) && mapDepth in COLOR_DEPTHS
            COLORS -> byte(1) <= 1 && depth in COLOR_DEPTHS
            GREY -> byte(1) <= 1 && (depth == 8 || depth == 16)
            else -> false
        }
        val most = if (isPacked) pixels / LONGEST_PACKET * (1 + bytesOf(depth)) else pixels * bytesOf(depth)
        return isKnown && pixels > 0 && descriptor and INTERLEAVED == 0 && start + most <= bytes.size
    }

    /**
     * Returns the pixels.
     *
     * @throws IOException if the data is cut short or refers to colours that the map does not have
     */
    fun decode(): BufferedImage {
        val image = BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB)
        val argb = (image.raster.dataBuffer as DataBufferInt).data
        val size = bytesOf(depth)
        var at = start
        var pixel = 0
        while (pixel < argb.size) {
            // A packet is one pixel that is repeated, or different pixels. Without packets, all pixels are one
            val head = if (isPacked) read(at++, 1) else 0
            val isRun = head >= LONGEST_PACKET
            val count = if (isPacked) minOf(head % LONGEST_PACKET + 1, argb.size - pixel) else argb.size
            repeat(count) { i ->
                argb[place(pixel++)] = if (kind == MAPPED) mapped(read(at, size)) else color(at, depth)
                if (!isRun || i == count - 1) at += size
            }
        }
        if (argb.all { it ushr 24 == 0 }) for (i in argb.indices) argb[i] = argb[i] or OPAQUE
        return image
    }

    /** Returns the index of a pixel in rows from the upper left. */
    private fun place(pixel: Int): Int {
        val x = pixel % width
        val y = pixel / width
        val column = if (descriptor and FROM_RIGHT != 0) width - 1 - x else x
        return (if (descriptor and FROM_TOP != 0) y else height - 1 - y) * width + column
    }

    private fun mapped(index: Int): Int {
        if (index - mapFirst !in 0 until mapLength) throw IOException("there is no colour $index")
        return color(mapStart + (index - mapFirst) * bytesOf(mapDepth), mapDepth)
    }

    /** Returns the colour of [depth] bits at byte [at]. */
    private fun color(at: Int, depth: Int): Int {
        val code = read(at, bytesOf(depth))
        val hasAlpha = descriptor and ALPHA_BITS != 0
        return when {
            depth == 8 -> OPAQUE or (code * 0x010101)
            kind == GREY -> (if (hasAlpha) code shr 8 shl 24 else OPAQUE) or ((code and 0xFF) * 0x010101)
            depth < 24 -> OPAQUE or (fiveBits(code shr 10) shl 16) or (fiveBits(code shr 5) shl 8) or fiveBits(code)
            depth == 32 && hasAlpha -> code
            else -> OPAQUE or code
        }
    }

    private fun fiveBits(code: Int): Int = ((code and 31) * 255 + 15) / 31

    /** Returns the number in [size] bytes from [at] on, of which the first is the lowest. */
    private fun read(at: Int, size: Int): Int {
        if (at + size > bytes.size) throw IOException("the file is cut short")
        var code = 0
        for (i in 0 until size) code = code or (byte(at + i) shl 8 * i)
        return code
    }

    private fun byte(at: Int): Int = bytes[at].toInt() and 0xFF

    private fun short(at: Int): Int = byte(at) or (byte(at + 1) shl 8)

    companion object {
        private const val HEADER = 18
        private const val MAPPED = 1
        private const val COLORS = 2
        private const val GREY = 3
        private const val PACKED = 8
        private const val LONGEST_PACKET = 128
        private const val ALPHA_BITS = 0x0F
        private const val FROM_RIGHT = 0x10
        private const val FROM_TOP = 0x20
        private const val INTERLEAVED = 0xC0
        private const val OPAQUE = 0xFF shl 24
        private val COLOR_DEPTHS = listOf(15, 16, 24, 32)

        private fun bytesOf(depth: Int): Int = (depth + 7) / 8

        /** Returns the picture in [bytes], which is not decoded yet, or null if it is of another format. */
        fun of(bytes: ByteArray): TgaImage? = if (bytes.size < HEADER) null else TgaImage(bytes).takeIf { it.isValid() }
    }
}
