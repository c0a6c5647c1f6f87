package dev.lazyz.scenes.stl

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextEncoding
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Reads the binary form: a header of 80 bytes, a count, and 50 bytes for each facet, little endian. For the last two
 * bytes of a facet see [StlColors].
 */
internal object StlBinary {
    private const val HEADER = 80

    /** Position of the first facet. */
    const val FACETS: Int = HEADER + 4

    /** Bytes of a facet: its normal, three corners, and a word. */
    const val FACET: Int = 50

    /** Bytes of the normal, three numbers. */
    const val NORMAL: Int = 12
    private const val WORD = 48

    /** Number of bytes to search for what does, or does not, occur in text. */
    private const val PROBE = 1024

    /** Words of the ASCII form, which do not occur in the headers of the binary form. */
    private val words = Regex("facet\\s+(normal|outer)|outer\\s+loop", RegexOption.IGNORE_CASE)

    /**
     * Whether a file of [size] bytes, of which [bytes] are the first, is in the binary form. It is if its size fits its
     * count of facets. Otherwise, words of the ASCII form decide. Without any, it is binary unless it begins with
     * `solid` and has no bytes that do not occur in text: binary files may begin with `solid`, too, but their count of
     * facets contains such bytes, for example zeros.
     */
    fun isBinary(bytes: ByteArray, size: Long): Boolean {
        if (isWhole(bytes, size)) return true
        val start = TextEncoding.start(bytes, PROBE)
        if (words.containsMatchIn(start)) return false
        val isMarked = start.trimStart().startsWith("solid", ignoreCase = true)
        return !isMarked || start.any { it < ' ' && !it.isWhitespace() }
    }

    /** Whether [size] is that of a binary file whose first bytes are [bytes]. */
    fun isWhole(bytes: ByteArray, size: Long): Boolean =
        bytes.size >= FACETS && FACETS + FACET * announced(bytes) == size

    /** Returns the number of facets that the header in [bytes] announces. */
    private fun announced(bytes: ByteArray): Long =
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER).toLong() and 0xFFFFFFFFL

    /** Reads the single solid of the file. */
    fun read(source: Source): Solid {
        val bytes = source.bytes
        val count = countOf(source, bytes.size.toLong()).toInt()
        val end = FACETS + FACET * count
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val colors = colors(source, buffer, end)
        val solid = Solid("", count, colors?.palette)
        for (facet in FACETS until end step FACET) {
            for (corner in 0 until 3) {
                val at = facet + NORMAL + corner * 12
                solid.add(buffer.getFloat(at), buffer.getFloat(at + 4), buffer.getFloat(at + 8))
            }
            if (colors != null) solid.color(colors.of(word(buffer, facet)))
        }
        return solid
    }

    private fun colors(source: Source, buffer: ByteBuffer, end: Int): StlColors? {
        val words = StlWords()
        for (facet in FACETS until end step FACET) words.add(word(buffer, facet))
        return StlColors.of(source, words)
    }

    /** Returns the word of the facet that begins at [facet]. */
    fun word(buffer: ByteBuffer, facet: Int): Int = buffer.getShort(facet + WORD).toInt() and 0xFFFF

    /**
     * Returns the number of facets of a file of [size] bytes, of which [source] has at least the header. Fails if they
     * are not all there.
     */
    fun countOf(source: Source, size: Long): Long {
        if (size < FACETS) {
            source.fail(
                "byte $size",
                "the file ends within the header of binary STL, which is $FACETS bytes",
                "export the model again; an ASCII file would begin with \"solid\"",
            )
        }
        val count = announced(source.bytes)
        val present = (size - FACETS) / FACET
        if (present < count) {
            source.fail(
                "byte $size",
                "the file ends within facet $present of the $count that byte $HEADER announces",
                "export or copy the model again",
            )
        }
        val rest = size - FACETS - FACET * count
        if (rest > 0) source.warn("$rest bytes after the last of $count facets are passed over")
        return count
    }
}
