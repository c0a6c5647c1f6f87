package dev.lazyz.scenes.aov

import dev.lazyz.aov.AovImage
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.time.LocalDateTime
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/**
 * NumPy's files of arrays, version 1.0, and archives of them.
 *
 * Source: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays".
 */
internal object Npy {
    /** The length of the header, with all before it, is a multiple of this. */
    private const val ALIGNMENT = 64
    private val MAGIC = byteArrayOf(0x93.toByte()) + "NUMPY".toByteArray(Charsets.US_ASCII) + byteArrayOf(1, 0)

    /** Halves of pairs, which are no characters alone, and what is written for them. */
    private val SURROGATES = 0xD800..0xDFFF
    private const val REPLACEMENT = 0xFFFD

    /** The least time that archives can store, so that the same arrays give the same bytes. */
    private val TIME = LocalDateTime.of(1980, 1, 1, 0, 0)

    /** Writes [image] as an array to [output]. */
    fun write(output: OutputStream, image: AovImage) {
        output.write(header(image))
        val channels = image.aov.channels.size
        val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * image.width * channels).order(ByteOrder.LITTLE_ENDIAN)
        val numbers = image.width * channels
        for (y in 0 until image.height) {
            bytes.clear()
            if (image.aov.isInteger) {
                bytes.asIntBuffer().put(image.ints, y * numbers, numbers)
            } else {
                bytes.asFloatBuffer().put(image.floats, y * numbers, numbers)
            }
            output.write(bytes.array())
        }
    }

    /** Writes [images] as an archive to [output], and closes it. */
    fun writeArchive(output: OutputStream, images: List<AovImage>) {
        ZipOutputStream(output).use { archive ->
            for (image in images) {
                archive.putNextEntry(ZipEntry("${image.aov.id}.npy").apply { timeLocal = TIME })
                write(archive, image)
                archive.closeEntry()
                if (image.names.isEmpty()) continue
                archive.putNextEntry(ZipEntry("${image.aov.id}-names.npy").apply { timeLocal = TIME })
                write(archive, image.names)
                archive.closeEntry()
            }
        }
    }

    /** Writes [texts] as an array: code points, with zeros up to the length of the longest. */
    private fun write(output: OutputStream, texts: List<String>) {
        val longest = maxOf(texts.maxOf { it.codePointCount(0, it.length) }, 1)
        output.write(header("<U$longest", "${texts.size},"))
        val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * longest).order(ByteOrder.LITTLE_ENDIAN)
        for (text in texts) {
            bytes.array().fill(0)
            bytes.clear()
            for (point in text.codePoints()) bytes.putInt(if (point in SURROGATES) REPLACEMENT else point)
            output.write(bytes.array())
        }
    }

    private fun header(image: AovImage): ByteArray {
        val channels = image.aov.channels.size
        val shape = listOf(image.height, image.width) + if (channels == 1) emptyList() else listOf(channels)
        return header(if (image.aov.isInteger) "<i4" else "<f4", shape.joinToString())
    }

    private fun header(type: String, shape: String): ByteArray {
        val text = "{'descr': '$type', 'fortran_order': False, 'shape': ($shape), }"
        val before = MAGIC.size + Short.SIZE_BYTES
        val length = (before + text.length + ALIGNMENT) / ALIGNMENT * ALIGNMENT - before
        val padded = text.padEnd(length - 1) + "\n"
        val size = byteArrayOf(length.toByte(), (length ushr 8).toByte())
        return MAGIC + size + padded.toByteArray(Charsets.US_ASCII)
    }
}
