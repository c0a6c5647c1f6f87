package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.ByteWindow
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * A body in one of the binary forms: numbers without separators.
 *
 * @param window the bytes of the body
 * @param size size of the file, in bytes
 */
internal class PlyBinaryBody(
    source: Source,
    header: PlyHeader,
    private val order: ByteOrder,
    private val window: ByteWindow,
    private val size: Long,
) : PlyBody(source, header) {
    private var buffer = ByteBuffer.wrap(window.bytes).order(order)

    /** Index of the next number in the bytes that are in memory. */
    val position: Int get() = window.position

    override val location get() = "byte ${window.offset}"

    override fun room(element: PlyElement): Int =
        minOf(element.count.toLong(), left / element.properties.sumOf { it.leastSize.toLong() }).toInt()

    /** Number of bytes that follow. */
    private val left: Long get() = size - window.offset

    /** Whether the file has [count] more bytes. If so, they are in memory. */
    private fun has(count: Long): Boolean {
        if (window.size - window.position >= count) return true
        if (count > left) return false
        val isThere = window.has(count)
        buffer = ByteBuffer.wrap(window.bytes).order(order)
        return isThere
    }

    override fun read(row: PlyRow): Boolean {
        for ((column, property) in row.properties.withIndex()) {
            if (!has(property.leastSize.toLong())) return cutOff()
            if (property.countType == null) {
                row.numbers[column] = next(property.type)
            } else {
                val count = listLength(property, next(property.countType))
                if (!has(count.toLong() * property.type.size)) return cutOff()
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
        return 3 * minOf(element.count.toLong(), left / triangle).toInt()
    }

    /** Whether each row of [element] is just one list of 32-bit integers, which [readLists] can read. */
    fun areLists(element: PlyElement): Boolean =
        element.properties.size == 1 && element.hasLists && element.properties[0].type == PlyType.INT

    /**
     * A fast path for [readRows] that reads lists. Calls [use] for each list, with the index of its first number
     * in the bytes that are in memory and the count of its numbers.
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
        if (!has(list.leastSize.toLong())) return -1.also { cutOff() }
        val count = listLength(list, next(checkNotNull(list.countType)))
        if (!has(Int.SIZE_BYTES * count.toLong())) return -1.also { cutOff() }
        window.position += Int.SIZE_BYTES * count
        return count
    }

    /** Returns the number of type [PlyType.INT] at byte [at]. */
    fun int(at: Int): Int = buffer.getInt(at)

    /**
     * A fast path for [readRows] that reads rows without lists, which all have the same size. Calls [use] for each row
     * that is present, with its number and its index in the bytes that are in memory. Returns the number of rows.
     */
    inline fun eachRow(element: PlyElement, use: (Int, Int) -> Unit): Int {
        val size = element.properties.sumOf { it.type.size }
        val count = room(element)
        var row = 0
        while (row < count) {
            val ready = minOf(count - row, rowsReady(size))
            val start = position
            for (i in 0 until ready) use(row + i, start + i * size)
            endRows(ready * size)
            row += ready
        }
        endElement(element, count)
        return count
    }

    /** Returns the number of rows of [size] bytes that are in memory. It is at least one: there must be one. */
    fun rowsReady(size: Int): Int {
        if (!has(size.toLong())) source.fail(location, "the file has become shorter while it was read", "read it again")
        return (window.size - window.position) / size
    }

    fun endRows(bytes: Int) {
        window.position += bytes
    }

    fun endElement(element: PlyElement, count: Int) {
        note(element, count)
        if (count < element.count) window.end()
    }

    /** Returns the number of type [PlyType.FLOAT] at byte [at]. */
    fun float(at: Int): Float = buffer.getFloat(at)

    /** Returns the number of type [PlyType.UCHAR] at byte [at]. */
    fun code(at: Int): Int = buffer.get(at).toInt() and 0xFF

    private fun cutOff(): Boolean {
        window.end()
        return false
    }

    private fun next(type: PlyType): Double {
        val at = window.position
        window.position = at + type.size
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
