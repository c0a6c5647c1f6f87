package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A body of numbers without anything between them. */
internal class PlyBinaryBody(source: Source, header: PlyHeader, order: ByteOrder) : PlyBody(source, header) {
    private val buffer = ByteBuffer.wrap(source.bytes).order(order)
    private val end = source.bytes.size

    /** Where the next number stands. */
    private var position = header.bodyPosition

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
