package dev.lazyz.scenes.off

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.text.TextNumbers
import kotlin.math.round

/**
 * Reads the numbers of the file line by line. Empty lines and comments, from a `#` to the end of the line, are skipped.
 * Not thread safe.
 */
internal class OffLine(private val source: Source) {
    private val lines = TextLines(source)
    private val decimal = Decimal()
    private var areFractions = BooleanArray(LEAST)

    /** The numbers of the line that was read last. Elements from [count] on are left over from earlier lines. */
    var numbers = DoubleArray(LEAST)
        private set

    /** Number of numbers in the line. */
    var count = 0
        private set

    /** Number of bytes after the line. */
    val bytesLeft: Int get() = source.bytes.size - lines.position

    /**
     * Moves to the next line that has words, without reading them, and returns its first word. Returns null at the end
     * of the file.
     */
    fun firstWord(): String? = if (nextWordOfText()) lines.word() else null

    /** Reads the numbers of the next line that is not empty. Returns false at the end of the file. */
    fun next(): Boolean {
        count = 0
        if (!nextWordOfText()) return false
        add()
        readRest()
        return true
    }

    /** Also reads the following lines, until there are [least] numbers. Returns false if the file ends earlier. */
    fun extend(least: Int): Boolean {
        while (count < least) {
            if (!nextWordOfText()) return false
            add()
            readRest()
        }
        return true
    }

    /** Reads the numbers after the word that was read last; there may be none. */
    fun readRest() {
        while (lines.nextWord() && !isComment()) add()
        lines.endLine()
    }

    /** Returns the next word of the line, or an empty string after the last. */
    fun wordOfLine(): String = if (lines.nextWord() && !isComment()) lines.word() else "".also { lines.endLine() }

    /** Makes [word] the line's first number, and reads the others. */
    fun readFrom(word: String) {
        count = 0
        append(parse(word), true)
        readRest()
    }

    /** Whether the number at [index] is written as a fraction: with a point, an exponent or letters. */
    fun isFraction(index: Int): Boolean = areFractions[index]

    /**
     * Returns the integer at [index], or fails if it is not an integer in 0..[most]. [what] describes it in the error.
     */
    fun whole(index: Int, what: String, most: Int = Int.MAX_VALUE): Int {
        val number = numbers[index]
        if (number >= 0.0 && number <= most && number == number.toInt().toDouble()) return number.toInt()
        val shown = if (number == round(number)) number.toLong().toString() else number.toString()
        fail("$what must be a whole number in 0..$most: $shown")
    }

    fun fail(problem: String, remedy: String = "correct the line or export the model again"): Nothing =
        source.fail("line ${lines.number}", problem, remedy)

    private fun nextWordOfText(): Boolean {
        while (lines.nextWordOfText()) {
            if (!isComment()) return true
            lines.endLine()
        }
        return false
    }

    private fun add() {
        val number = decimal.double(lines.bytes, lines.wordStart, lines.wordEnd)
        append(if (number.isNaN()) parse(lines.word()) else number, isFraction())
    }

    private fun parse(word: String): Double = TextNumbers.parse(word)
        ?: fail("\"$word\" is not a number", TextNumbers.remedy(word) ?: "correct the line or export the model again")

    private fun append(number: Double, isFraction: Boolean) {
        if (count == numbers.size) {
            numbers = numbers.copyOf(2 * count)
            areFractions = areFractions.copyOf(2 * count)
        }
        areFractions[count] = isFraction
        numbers[count++] = number
    }

    private fun isFraction(): Boolean {
        for (i in lines.wordStart until lines.wordEnd) {
            val byte = lines.bytes[i].toInt()
            if (byte != MINUS && byte != PLUS && byte !in ZERO..NINE) return true
        }
        return false
    }

    private fun isComment() = lines.bytes[lines.wordStart] == HASH

    private companion object {
        const val LEAST = 16
        const val HASH = '#'.code.toByte()
        const val MINUS = '-'.code
        const val PLUS = '+'.code
        const val ZERO = '0'.code
        const val NINE = '9'.code
    }
}
