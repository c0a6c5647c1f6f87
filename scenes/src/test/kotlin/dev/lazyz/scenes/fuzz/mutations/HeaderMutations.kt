package dev.lazyz.scenes.fuzz.mutations

import java.util.Random

/**
 * Changes the header of a file, counts and types first of all, and leaves what follows as it is.
 *
 * @param end what the header ends with
 */
internal class HeaderMutations(private val end: String) : Mutations {
    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray? {
        val length = length(input) ?: return null
        val header = String(input, 0, length, Charsets.ISO_8859_1)
        val words = String(other, 0, length(other) ?: return null, Charsets.ISO_8859_1)
        val isRetyped = random.nextBoolean()
        val changed = if (isRetyped) retyped(header, random) else TextMutations.mutate(header, words, random)
        return ByteMutations.replaced(input, 0, length, changed.toByteArray(Charsets.ISO_8859_1))
    }

    private fun length(bytes: ByteArray): Int? {
        val at = String(bytes, Charsets.ISO_8859_1).indexOf(end)
        return if (at < 0) null else at
    }

    /** Puts one word in the place of another of the same sort. */
    private fun retyped(header: String, random: Random): String {
        val sort = random.pick(sorts)
        val places = sort.pattern.findAll(header).toList()
        if (places.isEmpty()) return header
        return header.replaceRange(random.pick(places).range, random.pick(sort.words))
    }

    private class Sort(val pattern: Regex, val words: List<String>)

    private companion object {
        val types = listOf(
            "char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint32", "float64",
            "list uchar int", "list float double", "list uint uchar", "list list int",
        )
        val names = listOf(
            "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "u", "v", "s", "t", "texture_u",
            "texture_v",
            "vertex_indices", "vertex_index", "texcoord", "texnumber", "intensity",
        )
        val kinds = listOf("vertex", "face", "tristrips", "edge", "material", "multi_texture_vertex")
        val formats = listOf("ascii", "binary_little_endian", "binary_big_endian")

        fun sort(words: List<String>) = Sort(Regex(words.joinToString("|", "\\b(?:", ")\\b")), words)

        val sorts = listOf(
            sort(types),
            sort(names),
            sort(kinds),
            sort(formats),
            Sort(Regex("""(?<=\w )-?\d+(?=\n)"""), InterestingNumbers.words + (0..20).map { it.toString() }),
        )
    }
}
