package dev.lazyz.scenes.off

import dev.lazyz.scenes.loading.Source

/**
 * What stands before the tables: a word that says what each vertex has, and how many vertices and faces there are.
 *
 * @property hasNormals whether each vertex has a normal
 * @property hasColors whether each has a colour
 * @property hasPlaces whether each has texture coordinates
 */
internal class OffHeader private constructor(
    val hasNormals: Boolean,
    val hasColors: Boolean,
    val hasPlaces: Boolean,
    val vertexCount: Int,
    val faceCount: Int,
) {
    /** Numbers of a vertex, without its colour. */
    val plainNumbers: Int get() = 3 + (if (hasNormals) 3 else 0) + (if (hasPlaces) 2 else 0)

    companion object {
        private val keyword = Regex("((?:ST|C|N|4|n)*)(?:OFF|off)(\\d*)")

        /** Whether [word] is the first word of such a file. */
        fun isKeyword(word: String): Boolean = keyword.matches(word)

        /** Reads the header from [line], whose first line it is. The word may be missing: vertices are plain then. */
        fun read(source: Source, line: OffLine): OffHeader {
            val word = line.firstWord() ?: source.fail(null, "there are no words in the file", "export the model again")
            val match = keyword.matchEntire(word)
            val letters = match?.groupValues?.get(1) ?: ""
            val behind = match?.groupValues?.get(2) ?: word
            if ('4' in letters || 'n' in letters) {
                line.fail("\"$word\" has vertices of other than three dimensions", "export them with three, as OFF")
            }

            // Some programs do not part the word from the counts; the number of edges is never needed
            val first = behind.ifEmpty { line.wordOfLine() }
            if (first.equals("BINARY", ignoreCase = true)) {
                line.fail("the file is binary OFF, which is not read", "export the model as ASCII OFF")
            }
            if (first.isEmpty()) line.next() else line.readFrom(first)
            if (line.count < 2) line.fail("the numbers of vertices and faces should stand here")
            return OffHeader(
                'N' in letters,
                'C' in letters,
                "ST" in letters,
                line.whole(0, "the number of vertices"),
                line.whole(1, "the number of faces"),
            )
        }
    }
}
