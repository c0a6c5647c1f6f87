package dev.lazyz.scenes.stl

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.Floats
import dev.lazyz.scenes.triangulation.TextLines
import dev.lazyz.scenes.triangulation.TextNumbers
import dev.lazyz.scenes.triangulation.Triangulation

/**
 * The ASCII form: any number of solids, each a run of facets. Line breaks are free except after a solid's name. A loop
 * of more than three vertices, which the format does not know but some programs write, is cut into triangles.
 */
internal class StlAscii(private val source: Source) {
    private val lines = TextLines(source.bytes.let { if (hasMark(it)) it.copyOfRange(3, it.size) else it })
    private var words = emptyList<String>()
    private var at = 0

    /** Reads all solids. */
    fun read(): List<Solid> {
        val solids = ArrayList<Solid>()
        while (true) {
            if (!advance()) break
            expect("solid")
            solids.add(solid(Solid(restOfLine())))
        }
        return solids
    }

    private fun solid(solid: Solid): Solid {
        while (true) {
            when (val word = word("facet or endsolid")) {
                "facet" -> facet(solid)
                "endsolid" -> {
                    restOfLine()
                    return solid
                }
                else -> fail("\"$word\" stands where facet or endsolid should")
            }
        }
    }

    private fun facet(solid: Solid) {
        // The normal's three numbers are passed over, whatever they are
        if (peek() == "normal") repeat(4) { word("the facet's normal") }
        expect("outer")
        expect("loop")
        val corners = Floats()
        while (true) {
            when (val word = word("vertex or endloop")) {
                "vertex" -> repeat(3) { corners.add(number()) }
                "endloop" -> break
                else -> fail("\"$word\" stands where vertex or endloop should")
            }
        }
        if (corners.size < 9) fail("the loop has ${corners.size / 3} vertices, not 3")
        expect("endfacet")

        val triangles = Triangulation.triangles(DoubleArray(corners.size) { corners[it].toDouble() })
            ?: fail("the loop has ${corners.size / 3} vertices, which is more than a concave facet may have")
        for (corner in triangles) solid.add(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2])
    }

    /** Moves to the next word; false at the end of the file. */
    private fun advance(): Boolean {
        if (at < words.size) return true
        words = lines.nextWords() ?: return false
        at = 0
        return true
    }

    private fun peek(): String? = if (advance()) words[at].lowercase() else null

    private fun word(expected: String): String {
        if (!advance()) {
            source.fail(
                "line ${lines.number}",
                "the file ends where $expected should stand",
                "export or copy the model again",
            )
        }
        return words[at++].lowercase()
    }

    private fun expect(keyword: String) {
        val word = word(keyword)
        if (word != keyword) fail("\"$word\" stands where $keyword should")
    }

    private fun number(): Float {
        val word = word("a coordinate")
        val number = TextNumbers.parse(word) ?: fail("\"$word\" is not a number", TextNumbers.remedy(word))
        return number.toFloat()
    }

    private fun restOfLine(): String = words.drop(at).joinToString(" ").also { at = words.size }

    private fun fail(problem: String, remedy: String? = null): Nothing =
        source.fail("line ${lines.number}", problem, remedy ?: "correct the line or export the model again")

    private fun hasMark(bytes: ByteArray) =
        bytes.size >= 3 && bytes[0] == 0xEF.toByte() && bytes[1] == 0xBB.toByte() && bytes[2] == 0xBF.toByte()
}
