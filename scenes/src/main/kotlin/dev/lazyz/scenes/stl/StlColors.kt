package dev.lazyz.scenes.stl

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.ColorNumbers

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
