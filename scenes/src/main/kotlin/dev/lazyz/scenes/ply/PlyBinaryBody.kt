package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A body of numbers without anything between them. */
internal class PlyBinaryBody(source: Source, header: PlyHeader, order: ByteOrder) : PlyBody(source) {
    private val buffer = ByteBuffer.wrap(source.bytes).order(order)
    private val end = source.bytes.size

    /** Where the next number stands. */
    private var position = header.bodyPosition

    override val location get() = "byte $position"

    override fun announce(element: PlyElement) {
        val size = element.properties.sumOf { it.leastSize }
        if (size.toLong() * element.count > end - position) tooShort(element, end - position)
    }

    override fun read(row: PlyRow) {
        for ((column, property) in row.properties.withIndex()) {
            if (property.countType == null) {
                row.numbers[column] = next(property, property.type)
            } else {
                val count = next(property, property.countType)
                val list = row.lists[column]
                list.resize(listLength(property, count, (end - position) / property.type.size))
                for (i in 0 until list.size) list.numbers[i] = next(property, property.type)
            }
        }
    }

    private fun next(property: PlyProperty, type: PlyType): Double {
        if (end - position < type.size) {
            source.fail(location, "the file ends within property ${property.name}", "export or copy the model again")
        }
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
