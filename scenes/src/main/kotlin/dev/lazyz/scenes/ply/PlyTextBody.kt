package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.Decimal
import dev.lazyz.scenes.triangulation.TextLines
import dev.lazyz.scenes.triangulation.TextNumbers

/** A body of lines, one a row. */
internal class PlyTextBody(source: Source, header: PlyHeader) : PlyBody(source) {
    private val lines = TextLines(source.bytes, header.bodyPosition, header.bodyLine)
    private val decimal = Decimal()

    /** How many words of the line were not read yet; only a line with lists is counted. */
    private var wordsLeft = 0

    override val location get() = "line ${lines.number}"

    override fun announce(element: PlyElement) {
        // A number and the space behind it take two bytes, except for the very last number
        val remaining = source.bytes.size - lines.position
        if (2L * element.count * element.properties.size > remaining + 1L) tooShort(element, remaining)
    }

    override fun read(row: PlyRow) {
        findLine(row)
        if (row.element.hasLists) wordsLeft = lines.countWords()
        for ((column, property) in row.properties.withIndex()) {
            if (property.countType == null) {
                row.numbers[column] = next(property)
            } else {
                val list = row.lists[column]
                list.resize(listLength(property, next(property), wordsLeft))
                for (i in 0 until list.size) list.numbers[i] = next(property)
            }
        }
        if (lines.nextWord()) {
            val name = row.element.name
            source.fail(location, "\"${lines.word()}\" follows the last property of element $name", "shorten the line")
        }
    }

    /** Moves to the next line that has words. */
    private fun findLine(row: PlyRow) {
        do {
            if (!lines.nextLine()) {
                source.fail(
                    location,
                    "the file ends before all rows of element ${row.element.name}",
                    "export or copy the model again",
                )
            }
        } while (lines.isBlank())
    }

    private fun next(property: PlyProperty): Double {
        if (!lines.nextWord()) {
            source.fail(location, "the line ends before property ${property.name}", "complete the line")
        }
        wordsLeft--
        val number = decimal.double(source.bytes, lines.wordStart, lines.wordEnd)
        if (!number.isNaN()) return number
        val word = lines.word()
        return TextNumbers.parse(word) ?: source.fail(
            location,
            "\"$word\" is not a number, which property ${property.name} should be",
            TextNumbers.remedy(word),
        )
    }
}
