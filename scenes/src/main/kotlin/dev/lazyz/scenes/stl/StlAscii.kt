package dev.lazyz.scenes.stl

import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.Triangulation
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Reads the ASCII form: any number of solids, each a sequence of facets. Line breaks can be anywhere; only a solid's
 * name ends at one. `endsolid`, `endfacet` and `endloop` can be two words, and the name can follow `endsolid` without a
 * space. A word that begins with `#` begins a comment, which ends with the line. The format allows three
 * vertices in a loop. Some programs write more; such a loop is triangulated. A missing `endsolid` at the end of the
 * file is reported as a warning.
 *
 * @param origin the point to subtract from all positions
 * @param lines the text
 */
internal class StlAscii(
    private val source: Source,
    private val origin: Vector3dc,
    private val lines: TextLines = TextLines(source),
) {
    private val decimal = Decimal()

    private val isFar = origin != Vector3d()

    /** The corners of the current facet. */
    private val corners = Floats()

    /** Whether the word that [lines] read last has not been consumed yet. */
    private var isPeeked = false

    /** Reads all solids. Calls [begin] with the name of each, and adds its corners to what it returns. */
    fun read(begin: (name: String) -> CornerSink) {
        while (advance()) {
            if (isPadding()) {
                isPeeked = false
            } else {
                expect("solid")
                solid(begin(lines.restOfLine()))
            }
        }
    }

    /** Whether the word consists of control characters with which some programs fill or end a file. */
    private fun isPadding(): Boolean =
        (lines.wordStart until lines.wordEnd).all { lines.bytes[it] == NULL || lines.bytes[it] == END_OF_FILE }

    private fun solid(solid: CornerSink) {
        var hasFacets = false
        while (true) {
            if (hasFacets && !advance()) return source.warn("endsolid is missing at the end; all facets are read")
            take("facet or endsolid")
            if (lines.isWord("facet")) {
                facet(solid)
                hasFacets = true
            } else if (isEnd("solid") || lines.beginsWith("endsolid")) {
                lines.endLine()
                return
            } else {
                fail("\"${word()}\" stands where facet or endsolid should")
            }
        }
    }

    private fun facet(solid: CornerSink) {
        // Skip the normal's three numbers without parsing them
        if (advance() && lines.isWord("normal")) repeat(4) { take("the facet's normal") }
        expect("outer")
        expect("loop")
        corners.clear()
        while (true) {
            take("vertex or endloop")
            if (isEnd("loop")) break
            if (!lines.isWord("vertex")) fail("\"${word()}\" stands where vertex or endloop should")
            for (axis in 0 until 3) corners.add(coordinate(axis))
        }
        if (corners.size < 9) fail("the loop has ${corners.size / 3} vertices, not 3")
        take("endfacet")
        if (!isEnd("facet")) fail("\"${word()}\" stands where endfacet should")

        if (corners.size == 9) {
            for (corner in 0 until 3) add(corner, solid)
            return
        }
        val triangles = Triangulation.triangles(DoubleArray(corners.size) { corners[it].toDouble() }, source::step)
            ?: fail("the loop has ${corners.size / 3} vertices, ${Triangulation.TOO_MANY}")
        for (corner in triangles) add(corner, solid)
    }

    private fun add(corner: Int, solid: CornerSink) =
        solid.add(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2])

    /**
     * Moves to the next word that is not part of a comment, unless there is one that has not been consumed. Returns
     * false at the end of the file.
     */
    private fun advance(): Boolean {
        while (!isPeeked && lines.nextWordOfText()) {
            if (lines.bytes[lines.wordStart] == HASH) lines.endLine() else isPeeked = true
        }
        return isPeeked
    }

    private fun take(expected: String) {
        if (!advance()) {
            source.fail(
                "line ${lines.number}",
                "the file ends where $expected should stand",
                "export or copy the model again",
            )
        }
        isPeeked = false
    }

    /** Whether the word ends a [part], such as `endloop`, or `end` and then `loop`; in that case, takes both words. */
    private fun isEnd(part: String): Boolean {
        if (!lines.isWord("end")) return lines.isWord("end$part")
        expect(part)
        return true
    }

    private fun word(): String = lines.word().lowercase()

    private fun expect(keyword: String) {
        take(keyword)
        if (!lines.isWord(keyword)) fail("\"${word()}\" stands where $keyword should")
    }

    private fun coordinate(axis: Int): Float {
        take("a coordinate")
        if (isFar) return (double() - origin.get(axis)).toFloat()
        val number = decimal.float(lines.bytes, lines.wordStart, lines.wordEnd)
        if (!number.isNaN()) return number
        val word = word()
        return TextNumbers.parseFloat(word) ?: fail("\"$word\" is not a number", TextNumbers.remedy(word))
    }

    private fun double(): Double {
        val number = decimal.double(lines.bytes, lines.wordStart, lines.wordEnd)
        if (!number.isNaN()) return number
        val word = word()
        return TextNumbers.parse(word) ?: fail("\"$word\" is not a number", TextNumbers.remedy(word))
    }

    private fun fail(problem: String, remedy: String? = null): Nothing =
        source.fail("line ${lines.number}", problem, remedy ?: "correct the line or export the model again")

    private companion object {
        const val HASH = '#'.code.toByte()
        const val NULL = '\u0000'.code.toByte()
        const val END_OF_FILE = '\u001A'.code.toByte()
    }
}

/** Takes the corners of triangles, three for each. */
internal fun interface CornerSink {
    fun add(x: Float, y: Float, z: Float)
}
