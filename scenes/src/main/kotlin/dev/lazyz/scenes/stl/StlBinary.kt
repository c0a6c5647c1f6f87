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

    /** Number of bytes to search for bytes that do not occur in text. */
    private const val PROBE = 1024

    /**
     * Whether [bytes] are in the binary form. Its header may also begin with `solid`, like the ASCII form, but its
     * count of facets contains bytes that do not occur in text, such as zeros.
     */
    fun isBinary(bytes: ByteArray): Boolean {
        val start = TextEncoding.start(bytes, PROBE)
        val isMarked = start.trimStart().startsWith("solid", ignoreCase = true)
        return !isMarked || start.any { it < ' ' && !it.isWhitespace() }
    }

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
        val header = ByteBuffer.wrap(source.bytes).order(ByteOrder.LITTLE_ENDIAN)
        val count = header.getInt(HEADER).toLong() and 0xFFFFFFFFL
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
