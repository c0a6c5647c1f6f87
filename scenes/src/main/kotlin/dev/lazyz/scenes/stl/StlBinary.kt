package dev.lazyz.scenes.stl

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TextEncoding
import dev.lazyz.scenes.meshes.ColorNumbers
import dev.lazyz.scenes.text.TextLines
import java.io.InputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Reads the binary form: a header of 80 bytes, a count, and 50 bytes for each facet, little endian. For the last two
 * bytes of a facet see [StlColors]. The format first meant them as the number of bytes that follow the facet; they are
 * that if the size of the file fits.
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

    /** Facets after which the limits are checked. */
    const val CHECKED: Int = 1 shl 14

    /** Number of bytes to search for what does, or does not, occur in text. */
    private const val PROBE = 1024

    /** Neighbours in the ASCII form, which do not occur in the headers of the binary form. */
    private val words = setOf("facet" to "normal", "facet" to "outer", "outer" to "loop")

    /**
     * Whether a file of [size] bytes, of which [bytes] are the first, is in the binary form. It is if its size fits its
     * count of facets. Otherwise, words of the ASCII form decide. Without any, it is binary unless it begins with
     * `solid` and has no bytes that do not occur in text: binary files may begin with `solid`, too, but their count of
     * facets contains such bytes, for example zeros.
     */
    fun isBinary(bytes: ByteArray, size: Long): Boolean {
        if (isWhole(bytes, size)) return true
        val start = TextEncoding.start(bytes, PROBE)
        val pairs = TextLines.words(start.lowercase()).zipWithNext()
        if (pairs.any { (a, b) -> words.any { a.endsWith(it.first) && b.startsWith(it.second) } }) return false
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
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val layout = layout(source, bytes.size.toLong(), bytes::inputStream)
        val colors = if (layout.hasPayload) null else colors(source, buffer, layout.count.toInt())
        val solid = Solid("", layout.count.toInt(), colors?.palette)
        var facet = FACETS
        repeat(layout.count.toInt()) {
            source.step(3)
            addCorners(buffer, facet, solid)
            if (colors != null) solid.color(colors.of(word(buffer, facet)))
            facet += FACET + (if (layout.hasPayload) word(buffer, facet) else 0)
        }
        return solid
    }

    /** Adds the corners of the facet that begins at [facet] to [solid]. */
    fun addCorners(buffer: ByteBuffer, facet: Int, solid: CornerSink) {
        for (corner in 0 until 3) {
            val at = facet + NORMAL + corner * 12
            solid.add(buffer.getFloat(at), buffer.getFloat(at + 4), buffer.getFloat(at + 8))
        }
    }

    private fun colors(source: Source, buffer: ByteBuffer, count: Int): StlColors? {
        val words = StlWords()
        for (facet in FACETS until FACETS + FACET * count step FACET) {
            source.step()
            words.add(word(buffer, facet))
        }
        return StlColors.of(source, words)
    }

    /** Returns the word of the facet that begins at [facet]. */
    fun word(buffer: ByteBuffer, facet: Int): Int = buffer.getShort(facet + WORD).toInt() and 0xFFFF

    /**
     * Returns the number of facets of a file of [size] bytes, of which [source] has at least the header, and whether
     * bytes follow each. Fails if the facets are not all there. [open] opens the file once more.
     */
    fun layout(source: Source, size: Long, open: () -> InputStream): StlLayout {
        if (size < FACETS) {
            source.fail(
                "byte $size",
                "the file ends within the header of binary STL, which is $FACETS bytes",
                "export the model again; an ASCII file would begin with \"solid\"",
            )
        }
        val announced = announced(source.bytes)
        val present = (size - FACETS) / FACET
        if (present < announced) {
            source.fail(
                "byte $size",
                "the file ends within facet $present of the $announced that byte $HEADER announces",
                "export or copy the model again",
            )
        }

        // Some programs leave the count at 0, because they do not know it when they begin to write
        val count = if (announced == 0L) present else announced
        if (announced < count) source.warn("byte $HEADER announces 0 facets; the $count that the file has are read")
        val rest = size - FACETS - FACET * count
        val hasPayload = rest > 0 && payload(source, count, size, open) == rest
        if (hasPayload) {
            source.warn("the attributes of $count facets, $rest bytes, are not used")
        } else if (rest > 0) {
            source.warn("$rest bytes after the last of $count facets are passed over")
        }
        return StlLayout(count, hasPayload)
    }

    /** Returns how many bytes the words announce if each facet is followed by them; -1 if the file is too short. */
    private fun payload(source: Source, count: Long, size: Long, open: () -> InputStream): Long {
        var end = FACETS.toLong()
        eachFacet(source, count, open) { facet ->
            end += FACET + word(facet, 0)
            if (end > size) return -1
        }
        return end - FACETS - FACET * count
    }

    /** Calls [use] with each of [count] facets that are followed by as many bytes as their words say. */
    inline fun eachFacet(source: Source, count: Long, open: () -> InputStream, use: (ByteBuffer) -> Unit) {
        val facet = ByteBuffer.allocate(FACET).order(ByteOrder.LITTLE_ENDIAN)
        open().buffered().use { bytes ->
            bytes.skipNBytes(FACETS.toLong())
            for (number in 0 until count) {
                if (number % CHECKED == 0L) source.loading.decode(source, 0)
                bytes.readNBytes(facet.array(), 0, FACET)
                use(facet)
                bytes.skipNBytes(word(facet, 0).toLong())
            }
        }
    }
}

/**
 * Where the facets of a binary file are.
 *
 * @property count number of facets
 * @property hasPayload whether each is followed by as many bytes as its word says, instead of directly by the next one
 */
internal class StlLayout(val count: Long, val hasPayload: Boolean)

/** Statistics of the 16-bit words after the facets of a binary file. */
internal class StlWords {
    /** Number of words that are not zero. */
    var nonZero = 0
        private set

    /** Whether a word with bit 15 clear is not zero. */
    var hasUnmarked = false
        private set

    /** Whether a word with bit 15 set is neither black nor white, which programs write for "no colour". */
    var hasMarkedColors = false
        private set

    /** Whether bit 15 of all words is set. */
    var areMarked = true
        private set

    private var hasColors = false
    private var firstOther = -1
    private var areOthersEqual = true

    /**
     * Whether the words are colours as VisCAM writes them: at least one has bit 15 set and is not black, and all those
     * with bit 15 clear are the same.
     */
    val areVisCam: Boolean get() = hasColors && areOthersEqual

    fun add(word: Int) {
        if (word != 0) nonZero++
        if (word in 1 until BLACK) hasUnmarked = true
        if (word in BLACK + 1 until WHITE) hasMarkedColors = true
        if (word < BLACK) areMarked = false
        if (word > BLACK) hasColors = true
        if (word >= BLACK) return
        if (firstOther < 0) firstOther = word
        if (word != firstOther) areOthersEqual = false
    }

    /** Adds the words of [other], which follow. */
    fun add(other: StlWords) {
        nonZero += other.nonZero
        hasUnmarked = hasUnmarked || other.hasUnmarked
        hasMarkedColors = hasMarkedColors || other.hasMarkedColors
        areMarked = areMarked && other.areMarked
        hasColors = hasColors || other.hasColors
        areOthersEqual = areOthersEqual && other.areOthersEqual &&
            (firstOther < 0 || other.firstOther < 0 || firstOther == other.firstOther)
        if (firstOther < 0) firstOther = other.firstOther
    }

    private companion object {
        /** Bit 15 alone, the colour black. */
        const val BLACK = 1 shl 15

        /** All bits set, the colour white. */
        const val WHITE = 0xFFFF
    }
}

/**
 * The colours in the 16-bit words after a binary file's facets. There are three kinds (A. F. van der Geest, "Colour
 * STL", about 1999, and Materialise, "Colour in binary STL", as described in the manuals of VisCAM and Magics).
 *
 * - Materialise Magics: the header contains `COLOR=`, then red, green, blue and alpha of the whole solid, one byte
 *   each. A word with bit 15 clear is a facet's own colour: 5 bits each of red (the lowest), green and blue.
 * - MeshLab: the header contains `COLOR=` and a grey, whether or not facets have colours. A word with bit 15 set is a
 *   facet's colour, with red in the lowest bits.
 * - VisCAM, SolidView: the header does not contain `COLOR=`. A word with bit 15 set is a facet's colour: 5 bits each of
 *   blue (the lowest), green and red.
 *
 * With `COLOR=`, a word that is not zero and has bit 15 clear shows that the file is of the first kind; otherwise a
 * word with bit 15 set that is neither black nor white shows that it is of the second. If there is neither, the colour
 * of the whole counts only if all facets refer to it, by bit 15: MeshLab writes that header for models without colours,
 * too. Without `COLOR=`, words are colours only if one of them has bit 15 set and is not black, and if those with
 * bit 15 clear are all the same, because some programs store other numbers there. All colours are sRGB-encoded. Alpha
 * is ignored.
 *
 * @property palette the colours whose numbers [of] returns
 */
internal class StlColors private constructor(
    private val kind: Kind,
    private val wholeColor: Int,
    val palette: ColorNumbers
) {
    private enum class Kind { MAGICS, MESHLAB, VISCAM }

    private val numbers = IntArray(1 shl COLOR_BITS) { -1 }

    /** Returns the number of the colour of a facet with the given word, or -1 if it has none. */
    fun of(word: Int): Int {
        if ((kind == Kind.MAGICS) == (word and VALID != 0)) return wholeColor
        val code = word and VALID - 1
        if (numbers[code] < 0) {
            val low = level(code)
            val middle = level(code shr 5)
            val high = level(code shr 10)
            numbers[code] =
                if (kind == Kind.VISCAM) palette.add(high, middle, low, 1f) else palette.add(low, middle, high, 1f)
        }
        return numbers[code]
    }

    private fun level(bits: Int): Float = Rgba.linearOf((bits and MOST_LEVEL) / MOST_LEVEL.toDouble())

    companion object {
        private const val HEADER = 80
        private const val VALID = 1 shl 15
        private const val COLOR_BITS = 15
        private const val MOST_LEVEL = 31
        private val mark = "COLOR=".toByteArray()

        /** Returns the colours in the file whose facets have the [words], or null if there are none. */
        fun of(source: Source, words: StlWords): StlColors? {
            val at = (0..HEADER - mark.size - 4).firstOrNull { start ->
                mark.indices.all { source.bytes[start + it] == mark[it] }
            }
            val kind = when {
                at == null -> Kind.VISCAM.takeIf { words.areVisCam }
                words.hasUnmarked || (words.areMarked && !words.hasMarkedColors) -> Kind.MAGICS
                else -> Kind.MESHLAB.takeIf { words.hasMarkedColors }
            }
            if (kind == Kind.MAGICS) return magics(source, checkNotNull(at) + mark.size)
            if (kind != null) return StlColors(kind, -1, ColorNumbers())
            if (words.nonZero > 0) {
                source.warn("the attribute words of ${words.nonZero} facets are not used, for they are no colours")
            }
            return null
        }

        /** Returns the colours of a Magics file, whose colour of the whole begins at byte [at]. */
        private fun magics(source: Source, at: Int): StlColors {
            val palette = ColorNumbers()
            val (red, green, blue) = List(3) { SrgbDecoding.decodeByte(source.bytes[at + it].toInt() and 0xFF) }
            return StlColors(Kind.MAGICS, palette.add(red, green, blue, 1f), palette)
        }
    }
}
