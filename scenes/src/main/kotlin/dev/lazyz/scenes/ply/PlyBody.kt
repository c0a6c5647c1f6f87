package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import java.nio.ByteOrder

/** Hands out the rows of the body, one after the other, up to the end of the file. Not thread safe. */
internal abstract class PlyBody(protected val source: Source, private val header: PlyHeader) {
    /** Where the row that was read last stands. */
    abstract val location: String

    /** By element: how many rows were read. */
    private val present = HashMap<PlyElement, Int>()

    /** Reads the next row into [row]; false if the file ends before it does. */
    abstract fun read(row: PlyRow): Boolean

    /** Returns for how many rows of [element] what is left of the file has room; make no more for them. */
    abstract fun room(element: PlyElement): Int

    /** Returns how many corners of triangles the rows of [element] have at least, if all have the same number. */
    open fun cornerRoom(element: PlyElement): Int = 0

    /** Hands all rows of [element] that are there, with their numbers, to [use]; returns how many there are. */
    inline fun readRows(element: PlyElement, use: (Int, PlyRow) -> Unit): Int {
        val row = PlyRow(element)
        var count = 0
        while (count < element.count && read(row)) use(count++, row)
        note(element, count)
        return count
    }

    fun note(element: PlyElement, count: Int) {
        present[element] = count
    }

    /** Tells what was wrong with the rows, after the last. */
    open fun warn() {
        val isCut = present.any { (element, count) -> count < element.count }
        if (!isCut) return
        val rows = header.elements.filter { it in present }.joinToString { "${present[it]} of ${it.count} ${it.name}" }
        source.warn("the file is cut short and has only these rows: $rows; export or copy the model again")
    }

    /** Returns how long a list is whose length the file gives as [count]; Int.MAX_VALUE if it is longer than any. */
    protected fun listLength(property: PlyProperty, count: Double): Int {
        if (!(count >= 0.0) || (count < Int.MAX_VALUE && count != count.toInt().toDouble())) {
            source.fail(location, "the length of list ${property.name} is $count", "export the model again")
        }
        return count.toInt()
    }

    /** Returns the [number] of one of [count] vertices, as a row of this body gives it for a [part] such as a face. */
    fun vertexNumber(number: Double, count: Int, part: String): Int {
        if (number >= 0.0 && number < count && number == number.toInt().toDouble()) return number.toInt()
        val shown = if (number == StrictMath.rint(number)) number.toLong().toString() else number.toString()
        source.fail(
            location,
            "vertex number $shown is not one of the $count vertices, which count from 0",
            "correct the $part or export the model again",
        )
    }

    companion object {
        /** Returns the body that [header] describes. */
        fun of(source: Source, header: PlyHeader): PlyBody = when (header.format) {
            PlyFormat.ASCII -> PlyTextBody(source, header)
            PlyFormat.LITTLE_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.LITTLE_ENDIAN)
            PlyFormat.BIG_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.BIG_ENDIAN)
        }
    }
}
