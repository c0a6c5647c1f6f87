package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.ByteWindow
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A body in one of the binary forms: numbers without separators. */
internal class PlyBinaryBody(
    source: Source,
    header: PlyHeader,
    private val window: ByteWindow,
    size: Long,
    private val order: ByteOrder,
) : PlyBody(source, header) {
    private var buffer = ByteBuffer.wrap(window.bytes).order(order)

    /** Position where the file ends, in bytes from the start of the file. */
    private var end = size

    /** Index of the next number in [window]. */
    var at = (header.bodyPosition - window.passed).toInt()
        private set

    /** Position of the next number, in bytes from the start of the file. */
    private val position: Long get() = window.passed + at

    override val location get() = "byte $position"

    override fun room(element: PlyElement): Int =
        minOf(element.count.toLong(), (end - position) / element.properties.sumOf { it.leastSize.toLong() }).toInt()

    override fun read(row: PlyRow): Boolean {
        for ((column, property) in row.properties.withIndex()) {
            if (!has(property.leastSize)) return cutOff()
            if (property.countType == null) {
                row.numbers[column] = next(property.type)
            } else {
                val count = listLength(property, next(property.countType))
                if (!hasList(property, count)) return cutOff()
                val list = row.lists[column]
                list.resize(count.toInt())
                for (i in 0 until count.toInt()) {
                    list.numbers[i] = next(property.type)
                    step(1)
                }
            }
        }
        return true
    }

    override fun cornerRoom(element: PlyElement): Int {
        val list = element.properties.singleOrNull { it.countType != null } ?: return 0
        val triangle = element.properties.sumOf { it.leastSize.toLong() } + 3 * list.type.size
        return 3 * minOf(element.count.toLong(), (end - position) / triangle).toInt()
    }

    /** Whether there are [count] more bytes; they are then in memory. */
    private fun has(count: Int): Boolean = window.size - at >= count || (end - position >= count && fetched(count))

    private fun fetched(count: Int): Boolean {
        if (window.isAtEnd) return false
        window.readMore(at, count)
        at = 0
        buffer = ByteBuffer.wrap(window.bytes).order(order)
        return window.size >= count
    }

    /** Whether the [count] numbers of a list are there; they are then in memory. */
    private fun hasList(list: PlyProperty, count: Long): Boolean {
        if (count > (end - position) / list.type.size) return false
        val bytes = count * list.type.size
        if (window.isPart && bytes > LONGEST_LIST) {
            source.fail(location, "list ${list.name} has $count numbers, too many to be read part by part", "split it")
        }
        return has(bytes.toInt())
    }

    /** Whether each row of [element] is just one list of 32-bit integers, which [readLists] can read. */
    fun areLists(element: PlyElement): Boolean =
        element.properties.size == 1 && element.hasLists && element.properties[0].type == PlyType.INT

    /**
     * A fast path for [readRows] that reads lists. Calls [use] for each list, with the index of its first number, and
     * the count of its numbers.
     */
    inline fun readLists(element: PlyElement, use: (Int, Int) -> Unit) {
        var rows = 0
        while (rows < element.count) {
            val count = nextList(element.properties[0])
            if (count < 0) break
            step(1)
            use(at - Int.SIZE_BYTES * count, count)
            rows++
        }
        note(element, rows)
    }

    /** Moves past the current list and returns its length, or -1 if the file ends within it. */
    fun nextList(list: PlyProperty): Int {
        if (!has(list.leastSize)) return -1.also { cutOff() }
        val count = listLength(list, next(checkNotNull(list.countType)))
        if (!hasList(list, count)) return -1.also { cutOff() }
        at += Int.SIZE_BYTES * count.toInt()
        return count.toInt()
    }

    /** Returns the number of type [PlyType.INT] at [index]. */
    fun int(index: Int): Int = buffer.getInt(index)

    /**
     * A fast path for [readRows] that reads rows without lists, which all have the same size. Calls [use] for each row
     * that is present, with its index. Returns the number of rows.
     */
    inline fun eachRow(element: PlyElement, use: (Int) -> Unit): Int {
        val size = element.properties.sumOf { it.type.size }
        var count = 0
        while (count < element.count && nextRow(size)) {
            step(1)
            use(at - size)
            count++
        }
        note(element, count)
        return count
    }

    /** Moves past a row of [size] bytes; returns false if the file ends within it. */
    fun nextRow(size: Int): Boolean {
        if (!has(size)) return cutOff()
        at += size
        return true
    }

    /** Returns the number of type [PlyType.FLOAT] at [index]. */
    fun float(index: Int): Float = buffer.getFloat(index)

    /** Returns the number of type [PlyType.UCHAR] at [index]. */
    fun code(index: Int): Int = buffer.get(index).toInt() and 0xFF

    /** Ends the body here: what follows does not count. */
    private fun cutOff(): Boolean {
        at = window.size
        end = position
        return false
    }

    private fun next(type: PlyType): Double {
        val index = at
        at += type.size
        return when (type) {
            PlyType.CHAR -> buffer.get(index).toDouble()
            PlyType.UCHAR -> (buffer.get(index).toInt() and 0xFF).toDouble()
            PlyType.SHORT -> buffer.getShort(index).toDouble()
            PlyType.USHORT -> (buffer.getShort(index).toInt() and 0xFFFF).toDouble()
            PlyType.INT -> buffer.getInt(index).toDouble()
            PlyType.UINT -> (buffer.getInt(index).toLong() and 0xFFFFFFFFL).toDouble()
            PlyType.FLOAT -> buffer.getFloat(index).toDouble()
            PlyType.DOUBLE -> buffer.getDouble(index)
        }
    }

    private companion object {
        /** Most bytes of a list in a file that is not in memory. */
        const val LONGEST_LIST = 1 shl 25
    }
}
