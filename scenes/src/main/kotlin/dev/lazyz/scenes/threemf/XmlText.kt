package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.loading.Source
import java.io.BufferedInputStream
import java.io.FilterReader
import java.io.InputStream
import java.io.InputStreamReader
import java.io.Reader

/**
 * The characters of an XML part, which is UTF-8 or UTF-16 (Open Packaging Conventions, 6.2.5). Invalid bytes become
 * U+FFFD. The length of a tag or text is limited, so that a parser cannot run out of memory.
 */
internal class XmlText private constructor(private val source: Source, private val path: String, reader: Reader) :
    FilterReader(reader) {
    /** Number of characters since the last `>`. */
    private var length = 0L

    override fun read(): Int = CharArray(1).let { if (read(it, 0, 1) < 0) -1 else it[0].code }

    override fun read(characters: CharArray, offset: Int, count: Int): Int {
        val read = super.read(characters, offset, count)
        var i = offset + read - 1
        while (i >= offset && characters[i] != '>') i--
        length = if (i >= offset) offset + read - 1L - i else length + maxOf(read, 0)
        if (length > MOST_LENGTH) {
            source.fail(path, "has a tag or text of more than $MOST_LENGTH characters", "export the model again")
        }
        return read
    }

    companion object {
        private const val MOST_LENGTH = 16L shl 20
        private const val LARGEST_MARK = 3

        /** Returns the characters of the part called [path], whose bytes are [input]. */
        fun of(source: Source, path: String, input: InputStream): XmlText {
            val bytes = BufferedInputStream(input)
            bytes.mark(LARGEST_MARK)
            val first = bytes.readNBytes(LARGEST_MARK)
            bytes.reset()
            return XmlText(source, path, reader(bytes, first))
        }

        private fun reader(bytes: InputStream, first: ByteArray): Reader = when {
            first.size < 2 -> InputStreamReader(bytes, Charsets.UTF_8)

            // A byte order mark, which is not part of the text, or a first character without one
            first[0] == 0xFE.toByte() || first[0] == 0xFF.toByte() -> InputStreamReader(bytes, Charsets.UTF_16)
            first[0] == 0.toByte() -> InputStreamReader(bytes, Charsets.UTF_16BE)
            first[1] == 0.toByte() -> InputStreamReader(bytes, Charsets.UTF_16LE)
            else -> InputStreamReader(bytes, Charsets.UTF_8).also { if (first[0] == 0xEF.toByte()) it.read() }
        }
    }
}
