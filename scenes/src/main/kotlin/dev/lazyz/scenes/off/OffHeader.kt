package dev.lazyz.scenes.off

import dev.lazyz.scenes.loading.Source

/**
 * The part before the tables: a word that gives the attributes of vertices, and the numbers of vertices and faces.
 *
 * @property hasNormals whether each vertex has a normal
 * @property hasColors whether each vertex has a colour
 * @property hasPlaces whether each vertex has texture coordinates
 * @property vertexCount number of vertices
 * @property faceCount number of faces
 */
internal class OffHeader private constructor(
    val hasNormals: Boolean,
    val hasColors: Boolean,
    val hasPlaces: Boolean,
    val vertexCount: Int,
    val faceCount: Int,
) {
    /** Number of numbers for each vertex, without its colour. */
    val plainNumbers: Int get() = 3 + (if (hasNormals) 3 else 0) + (if (hasPlaces) 2 else 0)

    /** Whether vertices have only positions. */
    val isPlain: Boolean get() = !hasNormals && !hasColors && !hasPlaces

    companion object {
        /** Whether [word] is the first word of a file of this format. */
        fun isKeyword(word: String): Boolean = keyword(word) != null

        /** Returns the letters in front of `OFF`, and the digits behind it, or null if [word] is something else. */
        private fun keyword(word: String): Pair<String, String>? {
            var letters = 0
            while (letters < word.length) {
                letters += if (word.startsWith("ST", letters)) {
                    2
                } else if (word[letters] in "CN4n") {
                    1
                } else {
                    break
                }
            }
            val behind = word.drop(letters + 3)
            val isOne = word.startsWith("OFF", letters) || word.startsWith("off", letters)
            return if (isOne && behind.all { it in '0'..'9' }) word.take(letters) to behind else null
        }

        /**
         * Reads the header. [line] must be at the start of the file. The first word may be missing; vertices then have
         * only positions.
         */
        fun read(source: Source, line: OffLine): OffHeader {
            val word = line.firstWord() ?: source.fail(null, "there are no words in the file", "export the model again")
            val (letters, behind) = keyword(word) ?: ("" to word)
            if ('4' in letters || 'n' in letters) {
                line.fail("\"$word\" has vertices of other than three dimensions", "export them with three, as OFF")
            }

            // Some programs write no space between the word and the counts; the number of edges is not used
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
