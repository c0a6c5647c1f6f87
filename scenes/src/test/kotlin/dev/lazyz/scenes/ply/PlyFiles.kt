package dev.lazyz.scenes.ply

import java.io.ByteArrayOutputStream
import java.io.DataOutputStream

/** Writes one table of numbers in the three forms of PLY, from a header that has `FORMAT` where the form is named. */
internal object PlyFiles {
    /**
     * Each table is the types of its columns, a list's as `count/item`, and its rows of numbers and lists of numbers.
     */
    fun of(format: PlyFormat, header: String, tables: List<Pair<String, List<List<Any>>>>): ByteArray {
        val out = ByteArrayOutputStream()
        out.write(header.replace("FORMAT", format.id).toByteArray())
        for ((types, rows) in tables) {
            for (row in rows) write(out, format, types.split(' '), row)
        }
        return out.toByteArray()
    }

    private fun write(out: ByteArrayOutputStream, format: PlyFormat, types: List<String>, row: List<Any>) {
        if (format == PlyFormat.ASCII) {
            val words = row.flatMap { if (it is List<*>) listOf(it.size) + it else listOf(it) }
            out.write((words.joinToString(" ") + "\n").toByteArray())
            return
        }
        for ((type, cell) in types.zip(row)) {
            if (cell is List<*>) {
                val (count, item) = type.split('/')
                number(out, format, count, cell.size)
                for (number in cell) number(out, format, item, number as Number)
            } else {
                number(out, format, type, cell as Number)
            }
        }
    }

    private fun number(out: ByteArrayOutputStream, format: PlyFormat, type: String, value: Number) {
        val bytes = ByteArrayOutputStream()
        val data = DataOutputStream(bytes)
        when (PlyType.of(type)) {
            PlyType.CHAR, PlyType.UCHAR -> data.writeByte(value.toInt())
            PlyType.SHORT, PlyType.USHORT -> data.writeShort(value.toInt())
            PlyType.INT, PlyType.UINT -> data.writeInt(value.toLong().toInt())
            PlyType.FLOAT -> data.writeFloat(value.toFloat())
            PlyType.DOUBLE -> data.writeDouble(value.toDouble())
            null -> error(type)
        }
        val array = bytes.toByteArray()
        out.write(if (format == PlyFormat.LITTLE_ENDIAN) array.reversedArray() else array)
    }
}
