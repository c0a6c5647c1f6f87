package dev.lazyz.scenes.aov

import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovImage
import dev.lazyz.scenes.writers.PngChunks
import java.io.BufferedOutputStream
import java.io.OutputStream
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/** PNG files with 16 bits a channel, see [AovFormat.PNG]. */
internal object DeepPng {
    private const val MOST = 65535

    /** Filter 1 of the specification: differences to the pixel on the left. */
    private const val SUB = 1

    /** Returns why the numbers of [image] do not fit, or null if they do. */
    fun obstacle(image: AovImage): String? {
        if (!image.aov.isInteger) return null
        val most = image.ints.max()
        if (most.toLong() - image.aov.background.toLong() <= MOST) return null
        return "'${image.aov.id}' reaches $most, which 16 bits cannot hold; use .npy"
    }

    /** Writes [image] to [output], without closing it. */
    fun write(output: OutputStream, image: AovImage) {
        val own = image.aov.channels.size
        val all = if (own == 1) 1 else 3
        val chunks = PngChunks(output)
        chunks.header(image.width, image.height, depth = 16, if (all == 1) PngChunks.GREY else PngChunks.RGB)
        text(chunks, "aov", image.aov.id)
        if (image.aov == Aov.DEPTH) {
            text(chunks, "near", "${image.lowest}")
            text(chunks, "far", "${image.highest}")
        }

        // Each buffer of compressed bytes is a chunk
        val data = object : OutputStream() {
            override fun write(byte: Int) = write(byteArrayOf(byte.toByte()), 0, 1)

            override fun write(bytes: ByteArray, offset: Int, length: Int) =
                chunks.write(PngChunks.DATA, bytes.copyOfRange(offset, offset + length))
        }
        val deflater = Deflater()
        try {
            val chunked = BufferedOutputStream(data, PngChunks.DATA_SIZE)
            DeflaterOutputStream(chunked, deflater, PngChunks.DATA_SIZE).use { pixels ->
                for (y in 0 until image.height) pixels.write(row(image, y, own, all))
            }
        } finally {
            deflater.end()
        }
        chunks.write(PngChunks.END, ByteArray(0))
    }

    private fun text(chunks: PngChunks, keyword: String, value: String) =
        chunks.write("tEXt", "$keyword\u0000$value".toByteArray(Charsets.ISO_8859_1))

    /** Returns row [y]: the filter, then differences of [all] channels for each pixel, of which [own] are not 0. */
    private fun row(image: AovImage, y: Int, own: Int, all: Int): ByteArray {
        val bytes = ByteArray(1 + 2 * all * image.width)
        bytes[0] = SUB.toByte()
        val left = IntArray(all)
        for (i in 0 until all * image.width) {
            val channel = i % all
            val code = if (channel < own) code(image, image.numberAt(y * image.width + i / all, channel)) else 0
            bytes[1 + 2 * i] = ((code ushr 8) - (left[channel] ushr 8)).toByte()
            bytes[2 + 2 * i] = (code - left[channel]).toByte()
            left[channel] = code
        }
        return bytes
    }

    /** Returns the code of [number], 0..[MOST]. NaN is 0. */
    private fun code(image: AovImage, number: Double): Int {
        if (image.aov.isInteger) return (number - image.aov.background).toInt()
        if (image.aov == Aov.DEPTH && number == image.aov.background) return MOST
        val most = if (image.aov == Aov.DEPTH) MOST - 1 else MOST
        val place = (number - image.lowest) / (image.highest - image.lowest)
        return if (place > 0.0) Math.rint(minOf(place, 1.0) * most).toInt() else 0
    }
}
