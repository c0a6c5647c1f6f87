package dev.lazyz.scenes.images

import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.util.zip.CRC32
import java.util.zip.DeflaterOutputStream

/** Writes PNG files with any header and chunks, right or wrong (W3C, "Portable Network Graphics", 3rd edition). */
internal object PngFile {
    const val GREY = 0
    const val RGB = 2
    const val PALETTE = 3
    const val GREY_ALPHA = 4
    const val RGBA = 6

    /** Returns a file of one row for each of [rows], bytes as they are stored; [chunks] go before the picture. */
    fun of(
        width: Int,
        height: Int,
        depth: Int,
        type: Int,
        rows: List<ByteArray>,
        vararg chunks: Pair<String, ByteArray>,
    ): ByteArray {
        val out = ByteArrayOutputStream()
        out.write(byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10))
        val header = ByteArrayOutputStream()
        DataOutputStream(header).apply {
            writeInt(width)
            writeInt(height)
            write(byteArrayOf(depth.toByte(), type.toByte(), 0, 0, 0))
        }
        chunk(out, "IHDR", header.toByteArray())
        for ((name, data) in chunks) chunk(out, name, data)
        val picture = ByteArrayOutputStream()
        DeflaterOutputStream(picture).use { deflater ->
            for (row in rows) {
                deflater.write(0)
                deflater.write(row)
            }
        }
        chunk(out, "IDAT", picture.toByteArray())
        chunk(out, "IEND", ByteArray(0))
        return out.toByteArray()
    }

    fun bytes(vararg values: Int) = ByteArray(values.size) { values[it].toByte() }

    private fun chunk(out: ByteArrayOutputStream, name: String, data: ByteArray) {
        val crc = CRC32()
        crc.update(name.toByteArray())
        crc.update(data)
        DataOutputStream(out).apply {
            writeInt(data.size)
            write(name.toByteArray())
            write(data)
            writeInt(crc.value.toInt())
        }
    }
}
