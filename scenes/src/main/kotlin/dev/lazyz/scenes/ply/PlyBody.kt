package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import java.nio.ByteOrder
import kotlin.math.round

/** Reads the rows of the body in order, up to the end of the file. Not thread safe. */
internal abstract class PlyBody(protected val source: Source, private val header: PlyHeader) {
    /** The position of the row that was read last, for error messages. */
    abstract val location: String

    /** For each element, the number of rows that were read. */
    private val present = HashMap<PlyElement, Int>()

    /** Reads the next row into [row]. Returns false if the file ends within it. */
    abstract fun read(row: PlyRow): Boolean

    /**
     * Returns the maximum number of rows of [element] that the rest of the file can hold. Reserve memory for no more
     * rows.
     */
    abstract fun room(element: PlyElement): Int

    /**
     * Returns the minimum number of triangle corners in the rows of [element] if all lists have the same length, or 0
     * if it is not known.
     */
    open fun cornerRoom(element: PlyElement): Int = 0

    /**
     * Calls [use] for each row of [element] that is present, with its number, counted from 0. Returns the number of
     * rows. The row is reused for the next call.
     */
    inline fun readRows(element: PlyElement, use: (Int, PlyRow) -> Unit): Int {
        val row = PlyRow(element)
        var count = 0
        while (count < element.count && read(row)) {
            step(row.properties.size)
            use(count++, row)
        }
        note(element, count)
        return count
    }

    /** Counts [steps] of work, see [Source.step]. */
    fun step(steps: Int): Unit = source.step(steps)

    fun note(element: PlyElement, count: Int) {
        present[element] = count
    }

    /** Reports problems with the rows. Call it after the last row. */
    open fun warn() {
        val shown = header.elements.filter {
            step(1)
            it in present
        }
        if (shown.all { present.getValue(it) == it.count }) return
        val rows = shown.take(MOST_SHOWN).joinToString { "${present[it]} of ${it.count} ${it.name}" }
        source.warn("the file is cut short and has only these rows: $rows; export or copy the model again")
    }

    /**
     * Returns the length of a list, which the file gives as [count]. Fails if [count] is not an integer that the
     * largest type can have, 0 or more.
     */
    protected fun listLength(property: PlyProperty, count: Double): Long {
        if (!(count in 0.0..LONGEST_LIST) || count != round(count)) {
            source.fail(location, "the length of list ${property.name} is $count", "export the model again")
        }
        return count.toLong()
    }

    /**
     * Returns the vertex number [number] of the current row as an integer. Fails if it is not a number of one of
     * [count] vertices. [part], such as a face, describes the row in the error.
     */
    fun vertexNumber(number: Double, count: Int, part: String): Int {
        if (number >= 0.0 && number < count && number == number.toInt().toDouble()) return number.toInt()
        val shown = if (number == round(number)) number.toLong().toString() else number.toString()
        source.fail(
            location,
            "vertex number $shown is not one of the $count vertices, which count from 0",
            "correct the $part or export the model again",
        )
    }

    companion object {
        /** Elements whose rows a warning counts. */
        private const val MOST_SHOWN = 12

        /** The largest number of type [PlyType.UINT]. */
        private const val LONGEST_LIST = 4294967295.0

        /**
         * Returns the body in the form that [header] specifies, in a file of [size] bytes. The body begins in [window].
         */
        fun of(
            source: Source,
            header: PlyHeader,
            window: ByteWindow = ByteWindow(source),
            size: Long = source.bytes.size.toLong(),
        ): PlyBody = when (header.format) {
            PlyFormat.ASCII -> PlyTextBody(source, header, window, size)
            PlyFormat.LITTLE_ENDIAN -> PlyBinaryBody(source, header, window, size, ByteOrder.LITTLE_ENDIAN)
            PlyFormat.BIG_ENDIAN -> PlyBinaryBody(source, header, window, size, ByteOrder.BIG_ENDIAN)
        }
    }
}

/** One row of an element: [numbers] by column, and [lists] by column for columns that are lists. Rows are reused. */
internal class PlyRow(val element: PlyElement) {
    /** The properties by column, as an array, because they are read for each number. */
    val properties: Array<PlyProperty> = element.properties.toTypedArray()

    val numbers = DoubleArray(properties.size)
    val lists = Array(properties.size) { PlyList() }
}

/** The numbers of a list. The array grows as needed. */
internal class PlyList {
    /** The numbers. Elements from [size] on are left over from longer lists. */
    var numbers = DoubleArray(LEAST)
        private set

    var size = 0
        private set

    /** Sets the size to [size] numbers, which the caller must write. */
    fun resize(size: Int) {
        if (size > numbers.size) numbers = DoubleArray(size)
        this.size = size
    }

    private companion object {
        const val LEAST = 4
    }
}

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
