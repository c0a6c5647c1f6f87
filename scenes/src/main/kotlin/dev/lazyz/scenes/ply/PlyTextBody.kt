package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers

/** A body in the ASCII form: one line for each row. */
internal class PlyTextBody(source: Source, header: PlyHeader, window: ByteWindow, private val size: Long) :
    PlyBody(source, header) {
    private val lines = TextLines(window, (header.bodyPosition - window.passed).toInt(), header.bodyLine)
    private val decimal = Decimal()

    /** Number of words of the line that have not been read yet. It is valid only for rows with lists. */
    private var wordsLeft = 0

    /** Number of rows that follow, of all elements. */
    private var rowsLeft = header.elements.filter { it.properties.isNotEmpty() }.sumOf { it.count.toLong() }

    /** Number of rows with additional words after their last property. */
    private var longRows = 0

    override val location get() = "line ${lines.number}"

    override fun room(element: PlyElement): Int {
        // A number and the space after it take two bytes, except for the last number of the file
        val remaining = size - lines.passed
        return minOf(element.count.toLong(), (remaining + 1) / (2L * element.properties.size)).toInt()
    }

    override fun read(row: PlyRow): Boolean {
        do {
            if (!lines.nextLine()) return false
        } while (lines.isBlank())
        rowsLeft--

        // A file that ends without a line end, and with rows missing, may end within a number
        if (lines.isCutOff && (rowsLeft > 0 || lines.countWords() < row.properties.size)) return false
        if (row.element.hasLists) wordsLeft = lines.countWords()
        for ((column, property) in row.properties.withIndex()) {
            if (property.countType == null) {
                row.numbers[column] = next(property)
            } else {
                val count = listLength(property, next(property))
                if (count > wordsLeft && lines.isCutOff) return false
                if (count > wordsLeft) tooLong(property, count)
                val list = row.lists[column]
                list.resize(count.toInt())
                for (i in 0 until count.toInt()) list.numbers[i] = next(property)
            }
        }
        if (lines.nextWord()) longRows++
        return true
    }

    override fun warn() {
        super.warn()
        if (longRows > 0) source.warn("$longRows rows have words after their last property; these words are ignored")
    }

    private fun tooLong(property: PlyProperty, count: Long): Nothing = source.fail(
        location,
        "list ${property.name} announces $count numbers, but the line has $wordsLeft more",
        "complete the line",
    )

    private fun next(property: PlyProperty): Double {
        if (!lines.nextWord()) {
            source.fail(location, "the line ends before property ${property.name}", "complete the line")
        }
        wordsLeft--
        val number = decimal.double(lines.bytes, lines.wordStart, lines.wordEnd)
        if (!number.isNaN()) return number
        val word = lines.word()
        return TextNumbers.parse(word) ?: source.fail(
            location,
            "\"$word\" is not a number, which property ${property.name} should be",
            TextNumbers.remedy(word),
        )
    }
}
