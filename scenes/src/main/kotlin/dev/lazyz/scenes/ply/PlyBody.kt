package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.TextLines
import dev.lazyz.scenes.triangulation.TextNumbers
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** One row of an element: [numbers] by column, and [lists] by column where the column is a list. Used over and over. */
internal class PlyRow(val element: PlyElement) {
    val numbers = DoubleArray(element.properties.size)
    val lists = Array(element.properties.size) { NO_NUMBERS }

    private companion object {
        val NO_NUMBERS = DoubleArray(0)
    }
}

/** Hands out the rows of the body, one after the other. Not thread safe. */
internal abstract class PlyBody(protected val source: Source) {
    /** Where the row that was read last stands. */
    abstract val location: String

    /** Fails unless what is left of the file can hold all rows of [element]; call it before making room for them. */
    abstract fun announce(element: PlyElement)

    /** Reads the next row into [row]. */
    abstract fun read(row: PlyRow)

    /** Returns how long a list is whose length the file gives as [count], when no more than [most] numbers are left. */
    protected fun listLength(property: PlyProperty, count: Double, most: Int): Int {
        if (!(count >= 0.0) || count != StrictMath.floor(count)) {
            source.fail(location, "the length of list ${property.name} is $count", "export the model again")
        }
        if (count > most) {
            source.fail(
                location,
                "list ${property.name} announces ${count.toLong()} numbers, but there is room for $most",
                "export or copy the model again",
            )
        }
        return count.toInt()
    }

    protected fun tooShort(element: PlyElement, remaining: Int): Nothing = source.fail(
        location,
        "element ${element.name} announces ${element.count} rows, for which the remaining $remaining bytes are too few",
        "export or copy the model again",
    )

    companion object {
        /** Returns the body that [header] describes. */
        fun of(source: Source, header: PlyHeader): PlyBody = when (header.format) {
            PlyFormat.ASCII -> PlyTextBody(source, header)
            PlyFormat.LITTLE_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.LITTLE_ENDIAN)
            PlyFormat.BIG_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.BIG_ENDIAN)
        }
    }
}

/** A body of lines, one a row. */
private class PlyTextBody(source: Source, header: PlyHeader) : PlyBody(source) {
    private val lines = TextLines(source.bytes, header.bodyPosition, header.bodyLine)
    private var words = emptyList<String>()
    private var at = 0

    override val location get() = "line ${lines.number}"

    override fun announce(element: PlyElement) {
        // A number and the space behind it take two bytes, except for the very last number
        val remaining = source.bytes.size - lines.position
        if (2L * element.count * element.properties.size > remaining + 1L) tooShort(element, remaining)
    }

    override fun read(row: PlyRow) {
        words = lines.nextWords() ?: source.fail(
            location,
            "the file ends before all rows of element ${row.element.name}",
            "export or copy the model again",
        )
        at = 0
        for ((column, property) in row.element.properties.withIndex()) {
            if (property.countType == null) {
                row.numbers[column] = next(property)
            } else {
                val length = listLength(property, next(property), words.size - at)
                row.lists[column] = DoubleArray(length) { next(property) }
            }
        }
        if (at < words.size) {
            val name = row.element.name
            source.fail(location, "\"${words[at]}\" follows the last property of element $name", "shorten the line")
        }
    }

    private fun next(property: PlyProperty): Double {
        if (at == words.size) {
            source.fail(location, "the line ends before property ${property.name}", "complete the line")
        }
        val word = words[at++]
        return TextNumbers.parse(word) ?: source.fail(
            location,
            "\"$word\" is not a number, which property ${property.name} should be",
            TextNumbers.remedy(word),
        )
    }
}

/** A body of numbers without anything between them. */
private class PlyBinaryBody(source: Source, header: PlyHeader, order: ByteOrder) : PlyBody(source) {
    private val buffer = ByteBuffer.wrap(source.bytes).order(order).position(header.bodyPosition)

    override val location get() = "byte ${buffer.position()}"

    override fun announce(element: PlyElement) {
        val size = element.properties.sumOf { it.leastSize }
        if (size.toLong() * element.count > buffer.remaining()) tooShort(element, buffer.remaining())
    }

    override fun read(row: PlyRow) {
        for ((column, property) in row.element.properties.withIndex()) {
            if (property.countType == null) {
                row.numbers[column] = next(property, property.type)
            } else {
                val count = next(property, property.countType)
                val length = listLength(property, count, buffer.remaining() / property.type.size)
                row.lists[column] = DoubleArray(length) { next(property, property.type) }
            }
        }
    }

    private fun next(property: PlyProperty, type: PlyType): Double {
        if (buffer.remaining() < type.size) {
            source.fail(location, "the file ends within property ${property.name}", "export or copy the model again")
        }
        return when (type) {
            PlyType.CHAR -> buffer.get().toDouble()
            PlyType.UCHAR -> (buffer.get().toInt() and 0xFF).toDouble()
            PlyType.SHORT -> buffer.getShort().toDouble()
            PlyType.USHORT -> (buffer.getShort().toInt() and 0xFFFF).toDouble()
            PlyType.INT -> buffer.getInt().toDouble()
            PlyType.UINT -> (buffer.getInt().toLong() and 0xFFFFFFFFL).toDouble()
            PlyType.FLOAT -> buffer.getFloat().toDouble()
            PlyType.DOUBLE -> buffer.getDouble()
        }
    }
}
