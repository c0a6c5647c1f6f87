package dev.lazyz.scenes.stl

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.TextEncoding
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** The binary form: 80 bytes of header, a count, and 50 bytes a facet, little endian; for the last two see [StlColors]. */
internal object StlBinary {
    private const val HEADER = 80
    private const val FACETS = HEADER + 4
    private const val FACET = 50
    private const val NORMAL = 12
    private const val WORD = 48

    /** How far a text is searched for bytes that text has not. */
    private const val PROBE = 1024

    /**
     * Whether [bytes] are of the binary form. Its header may begin with `solid`, the mark of the ASCII form, but its
     * count of facets has bytes that no text has, zeros at least.
     */
    fun isBinary(bytes: ByteArray): Boolean {
        val start = TextEncoding.start(bytes, PROBE)
        val isMarked = start.trimStart().startsWith("solid", ignoreCase = true)
        return !isMarked || start.any { it < ' ' && !it.isWhitespace() }
    }

    /** Reads the one solid of the file. */
    fun read(source: Source): Solid {
        val bytes = source.bytes
        if (bytes.size < FACETS) {
            source.fail(
                "byte ${bytes.size}",
                "the file ends within the header of binary STL, which is $FACETS bytes",
                "export the model again; an ASCII file would begin with \"solid\"",
            )
        }
        val count = countOf(bytes)
        val present = (bytes.size - FACETS) / FACET
        if (present < count) {
            source.fail(
                "byte ${bytes.size}",
                "the file ends within facet $present of the $count that byte $HEADER announces",
                "export or copy the model again",
            )
        }
        val end = FACETS + FACET * count.toInt()
        if (end < bytes.size) source.warn("${bytes.size - end} bytes after the last of $count facets are passed over")

        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val colors = colors(source, buffer, end)
        val solid = Solid("", count.toInt(), colors?.palette)
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

    private fun word(buffer: ByteBuffer, facet: Int): Int = buffer.getShort(facet + WORD).toInt() and 0xFFFF

    private fun countOf(bytes: ByteArray): Long =
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER).toLong() and 0xFFFFFFFFL
}
