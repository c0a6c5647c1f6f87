package dev.lazyz.scenes.loading

import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InputStreamReader
import java.io.OutputStreamWriter
import java.nio.charset.Charset

/**
 * Text that begins with Unicode's byte order mark, U+FEFF: UTF-16 of either byte order, or UTF-8 (The Unicode
 * Standard, section 23.8). Text without a mark stays unchanged.
 */
internal object TextEncoding {
    private const val PIECE = 8192
    private val marks = mapOf(
        Charsets.UTF_8 to byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte()),
        Charsets.UTF_16LE to byteArrayOf(0xFF.toByte(), 0xFE.toByte()),
        Charsets.UTF_16BE to byteArrayOf(0xFE.toByte(), 0xFF.toByte()),
    )

    /** Whether [bytes] begin with a byte order mark. */
    fun hasMark(bytes: ByteArray): Boolean = charset(bytes) != null

    /** Returns the bytes of [source] as UTF-8 without a mark; the same array if there is no mark. */
    fun utf8(source: Source): ByteArray {
        val bytes = source.bytes
        val charset = charset(bytes) ?: return bytes
        val mark = marks.getValue(charset).size
        if (charset == Charsets.UTF_8) return bytes.copyOfRange(mark, bytes.size)
        val out = ByteArrayOutputStream(bytes.size / 2)
        OutputStreamWriter(out, Charsets.UTF_8).use { writer ->
            val reader = InputStreamReader(ByteArrayInputStream(bytes, mark, bytes.size - mark), charset)
            val piece = CharArray(PIECE)
            while (true) {
                val count = reader.read(piece)
                if (count < 0) break
                writer.write(piece, 0, count)
                source.step(count)
            }
        }
        return out.toByteArray()
    }

    /**
     * Returns the text in the first [count] of [bytes] without a mark. Without a mark, decodes as ISO 8859-1, which
     * accepts any bytes.
     */
    fun start(bytes: ByteArray, count: Int): String {
        val length = minOf(bytes.size, count)
        val charset = charset(bytes) ?: return String(bytes, 0, length, Charsets.ISO_8859_1)
        val mark = marks.getValue(charset).size
        return String(bytes, mark, maxOf(length - mark, 0), charset)
    }

    private fun charset(bytes: ByteArray): Charset? =
        marks.entries.firstOrNull { (_, mark) -> startsWith(bytes, mark) }?.key

    private fun startsWith(bytes: ByteArray, mark: ByteArray) =
        bytes.size >= mark.size && mark.indices.all { bytes[it] == mark[it] }
}
