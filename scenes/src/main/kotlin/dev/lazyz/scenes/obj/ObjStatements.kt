package dev.lazyz.scenes.obj

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.TextLines
import dev.lazyz.scenes.triangulation.TextNumbers

/**
 * The statements of an OBJ file that carry polygons, in the form that `ObjReader` gets right.
 *
 * It follows what the parser does not: objects, smoothing groups and vertex colours. And it mends or refuses what the
 * parser would silently misread: tabs, `1/ 2/ 3/`, faces of which only some corners have a texture coordinate or a
 * normal, numbers beyond 31 bits, and number 0. Points, lines and free-form geometry are dropped with a warning.
 */
internal class ObjStatements(private val source: Source) : StatementReader(decode(source.bytes)) {
    /** How many `o` statements there were so far. */
    var objectNumber = 0
        private set

    /** Whether faces without normals are to look smooth: not after `s off`. */
    var isSmooth = true
        private set

    /** The words of the `v`, `vt` or `vn` statement that was read last. */
    var words = emptyList<String>()
        private set

    private val dropped = LinkedHashMap<String, Int>()

    override fun prepare(keyword: String, statement: String): String? {
        when (keyword) {
            "v", "vt", "vn" -> return numbers(statement)
            "f", "fo" -> return face(statement)
            "usemtl", "mtllib" -> return statement
            "o" -> objectNumber++
            "s" -> isSmooth = withoutComment(statement).substring(1).trim().lowercase() !in listOf("off", "0")
            in DRAWN -> dropped.merge(keyword, 1, Int::plus)
        }
        return null
    }

    /** Warns of what was dropped; call it at the end. */
    fun warnOfDropped() {
        for ((keyword, count) in dropped) {
            source.warn("${DRAWN.getValue(keyword)} are not drawn; $count statements \"$keyword\" are passed over")
        }
    }

    fun fail(problem: String, remedy: String, cause: Throwable? = null): Nothing =
        source.fail("line $number", problem, remedy, cause)

    private fun numbers(statement: String): String {
        words = TextLines.words(withoutComment(statement))
        val least = if (words[0] == "vt") 1 else 3
        if (words.size <= least) {
            fail("\"${words[0]}\" needs $least numbers, not ${words.size - 1}", LINE_REMEDY)
        }

        // Java spells out what other languages abbreviate: nan, inf
        return words.mapIndexed { i, word -> if (i == 0) word else number(word) }.joinToString(" ")
    }

    private fun number(word: String): String = if (word.all { it in PLAIN }) {
        word
    } else {
        TextNumbers.parse(word)?.toString()
            ?: fail("\"$word\" is not a number", TextNumbers.remedy(word) ?: LINE_REMEDY)
    }

    private fun face(statement: String): String? {
        val corners = TextLines.words(withoutComment(statement)).drop(1).map { it.split('/') }
        if (corners.size < 3) {
            source.warn("line $number: a face of ${corners.size} corners is left out")
            return null
        }
        val hasTexture = corners.all { !it.getOrNull(1).isNullOrEmpty() }
        val hasNormals = corners.all { !it.getOrNull(2).isNullOrEmpty() }
        val text = StringBuilder("f")
        for (corner in corners) {
            if (corner.size > 3) fail("\"${corner.joinToString("/")}\" is more than three numbers", INDEX_REMEDY)
            text.append(' ').append(index(corner[0]))
            if (hasTexture || hasNormals) text.append('/')
            if (hasTexture) text.append(index(corner[1]))
            if (hasNormals) text.append('/').append(index(corner[2]))
        }
        return text.toString()
    }

    private fun index(word: String): String {
        val number = word.toIntOrNull()
        if (number == null || number == 0 || word[0] == '+') {
            fail("\"$word\" cannot number a vertex", INDEX_REMEDY)
        }
        return word
    }

    private companion object {
        const val PLAIN = "0123456789+-.eE"
        const val INDEX_REMEDY = "write v, v/vt, v//vn or v/vt/vn, counting from 1, or from -1 backward"
        const val LINE_REMEDY = "correct the line or export the model again"
        val DRAWN = mapOf(
            "p" to "points",
            "l" to "lines",
            "curv" to "curves",
            "curv2" to "curves",
            "surf" to "free-form surfaces",
        )
    }
}
