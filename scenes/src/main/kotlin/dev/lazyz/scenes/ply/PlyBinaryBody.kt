package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A body in one of the binary forms: numbers without separators. */
internal class PlyBinaryBody(source: Source, header: PlyHeader, order: ByteOrder) : PlyBody(source, header) {
    private val buffer = ByteBuffer.wrap(source.bytes).order(order)
    val end = source.bytes.size

    /** Position of the next number, in bytes from the start of the file. */
    var position = header.bodyPosition
        private set

    override val location get() = "byte $position"

    override fun room(element: PlyElement): Int =
        minOf(element.count.toLong(), (end - position) / element.properties.sumOf { it.leastSize.toLong() }).toInt()

    override fun read(row: PlyRow): Boolean {
        for ((column, property) in row.properties.withIndex()) {
            if (end - position < property.leastSize) return cutOff()
            if (property.countType == null) {
                row.numbers[column] = next(property.type)
            } else {
                val count = listLength(property, next(property.countType))
                if (count > (end - position) / property.type.size) return cutOff()
                val list = row.lists[column]
                list.resize(count)
                for (i in 0 until count) list.numbers[i] = next(property.type)
            }
        }
        return true
    }

    override fun cornerRoom(element: PlyElement): Int {
        val list = element.properties.singleOrNull { it.countType != null } ?: return 0
        val triangle = element.properties.sumOf { it.leastSize.toLong() } + 3 * list.type.size
        return 3 * minOf(element.count.toLong(), (end - position) / triangle).toInt()
    }

    /** Whether each row of [element] is just one list of 32-bit integers, which [readLists] can read. */
    fun areLists(element: PlyElement): Boolean =
        element.properties.size == 1 && element.hasLists && element.properties[0].type == PlyType.INT

    /**
     * A fast path for [readRows] that reads lists. Calls [use] for each list, with the position of its first number in
     * bytes and the count of its numbers.
     */
    inline fun readLists(element: PlyElement, use: (Int, Int) -> Unit) {
        var rows = 0
        while (rows < element.count) {
            val count = nextList(element.properties[0])
            if (count < 0) break
            use(position - Int.SIZE_BYTES * count, count)
            rows++
        }
        note(element, rows)
    }

    /** Moves past the current list and returns its length, or -1 if the file ends within it. */
    fun nextList(list: PlyProperty): Int {
        if (end - position < list.leastSize) return -1.also { cutOff() }
        val count = listLength(list, next(checkNotNull(list.countType)))
        if (count > (end - position) / Int.SIZE_BYTES) return -1.also { cutOff() }
        position += Int.SIZE_BYTES * count
        return count
    }

    /** Returns the number of type [PlyType.INT] at byte [at]. */
    fun int(at: Int): Int = buffer.getInt(at)

    /**
     * A fast path for [readRows] that reads rows without lists, which all have the same size. Calls [use] for each row
     * that is present, with its number and its position in bytes. Returns the number of rows.
     */
    inline fun eachRow(element: PlyElement, use: (Int, Int) -> Unit): Int {
        val size = element.properties.sumOf { it.type.size }
        val start = position
        val count = minOf(element.count, (end - start) / size)
        for (row in 0 until count) use(row, start + row * size)
        endRows(element, count, if (count < element.count) end else start + count * size)
        return count
    }

    fun endRows(element: PlyElement, count: Int, position: Int) {
        note(element, count)
        this.position = position
    }

    /** Returns the number of type [PlyType.FLOAT] at byte [at]. */
    fun float(at: Int): Float = buffer.getFloat(at)

    /** Returns the number of type [PlyType.UCHAR] at byte [at]. */
    fun code(at: Int): Int = buffer.get(at).toInt() and 0xFF

    private fun cutOff(): Boolean {
        position = end
        return false
    }

    private fun next(type: PlyType): Double {
        val at = position
        position += type.size
        return when (type) {
            PlyType.CHAR -> buffer.get(at).toDouble()
            PlyType.UCHAR -> (buffer.get(at).toInt() and 0xFF).toDouble()
            PlyType.SHORT -> buffer.getShort(at).toDouble()
            PlyType.USHORT -> (buffer.getShort(at).toInt() and 0xFFFF).toDouble()
            PlyType.INT -> buffer.getInt(at).toDouble()
            PlyType.UINT -> (buffer.getInt(at).toLong() and 0xFFFFFFFFL).toDouble()
            PlyType.FLOAT -> buffer.getFloat(at).toDouble()
            PlyType.DOUBLE -> buffer.getDouble(at)
        }
    }
}
