package dev.lazyz.spark.triangles.files

import dev.lazyz.scenes.SceneFormatException
import java.io.Serializable
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

/**
 * A binary PLY file whose vertices and faces are records of one length each.
 *
 * @property isBig whether the highest byte of a number is the first
 * @property vertexStride bytes of a vertex
 * @property places positions of x, y and z in a vertex
 * @property faceStride bytes of a face: the number of its corners, and three numbers of vertices, first of all
 */
internal class SplitPly private constructor(
    val bytes: SharedFile,
    private val isBig: Boolean,
    private val start: Long,
    private val vertexCount: Long,
    val vertexStride: Int,
    val places: IntArray,
    private val faceCount: Long,
    val faceStride: Int,
) : Serializable {
    fun vertexRanges(partitionBytes: Long): List<ByteRange> =
        ByteRange.divide(start, vertexCount, vertexStride, partitionBytes)

    fun faceRanges(partitionBytes: Long): List<ByteRange> =
        ByteRange.divide(start + vertexCount * vertexStride, faceCount, faceStride, partitionBytes)

    /** Reads the bytes of a range. */
    fun read(range: ByteRange, stride: Int): ByteBuffer {
        val order = if (isBig) ByteOrder.BIG_ENDIAN else ByteOrder.LITTLE_ENDIAN
        val read = bytes.read(range.start, range.count * stride, order)
        if (read.limit() < range.count * stride) fail(bytes.path, "byte ${range.start}", "the file is too short")
        return read
    }

    /** Checks the number of a vertex, which is at byte [at] of the file. */
    fun checked(vertex: Long, at: Long): Long {
        if (vertex !in 0 until vertexCount) {
            fail(bytes.path, "byte $at", "there is no vertex $vertex; the file has $vertexCount")
        }
        return vertex
    }

    companion object {
        private const val serialVersionUID = 1L
        private const val MOST_HEADER = 1 shl 16
        private val SIZES = mapOf(
            "char" to 1, "int8" to 1, "uchar" to 1, "uint8" to 1, "short" to 2, "int16" to 2, "ushort" to 2,
            "uint16" to 2, "int" to 4, "int32" to 4, "uint" to 4, "uint32" to 4, "float" to 4, "float32" to 4,
            "double" to 8, "float64" to 8,
        )
        private val BYTES = setOf("uchar", "uint8")
        private val NUMBERS = setOf("int", "int32", "uint", "uint32")

        /** Properties of vertices that change the picture, and that tables do not have. */
        private val OTHERS = setOf("nx", "ny", "nz", "red", "green", "blue", "alpha", "u", "v", "s", "t")
        private const val END = "end_header\n"

        fun fail(path: String, place: String?, problem: String): Nothing = throw SceneFormatException(
            path, place, problem, "load it with Scenes.load, or convert it to binary PLY with plain triangles",
        )

        fun open(spark: SparkSession, path: String): SplitPly {
            val file = SharedFile.of(spark, path)
            val head = file.read(0, MOST_HEADER, ByteOrder.LITTLE_ENDIAN)
            val text = String(head.array(), 0, head.limit(), Charsets.ISO_8859_1)
            val end = text.indexOf(END)
            if (!text.startsWith("ply") || end < 0) fail(path, null, "has no header of PLY")
            return of(file, text.substring(0, end).lines().map { it.trim().split(' ') }, (end + END.length).toLong())
        }

        private fun of(file: SharedFile, lines: List<List<String>>, start: Long): SplitPly {
            val path = file.path
            val format = lines.firstOrNull { it[0] == "format" }?.getOrNull(1) ?: fail(path, null, "has no format")
            if (!format.startsWith("binary_")) fail(path, "line 2", "is a text file, which cannot be divided")
            val elements = lines.indices.filter { lines[it][0] == "element" }
            if (elements.map { lines[it][1] } != listOf("vertex", "face")) {
                fail(path, "header", "has other elements than vertices and faces, in this order")
            }
            fun properties(from: Int) =
                lines.subList(from + 1, elements.firstOrNull { it > from } ?: lines.size).filter { it[0] == "property" }
            val vertex = properties(elements[0])
            val face = properties(elements[1])
            val names = vertex.map { it.last() }
            names.firstOrNull { it in OTHERS }?.let { fail(path, "header", "vertices have '$it', which tables do not have") }
            val offsets = vertex.runningFold(0) { at, property -> at + (SIZES[property[1]] ?: fail(path, "header", "lists")) }
            val places = IntArray(3) { axis ->
                val number = names.indexOf("xyz"[axis].toString())
                val isFloat = number >= 0 && vertex[number][1] in setOf("float", "float32")
                if (isFloat) offsets[number] else fail(path, "header", "vertices have no 32-bit '${"xyz"[axis]}'")
            }
            val list = face.singleOrNull()
            if (list?.getOrNull(1) != "list" || list[2] !in BYTES || list[3] !in NUMBERS) {
                fail(path, "header", "faces are not a list of a byte and 32-bit numbers, and nothing else")
            }
            val faceStride = 1 + 3 * 4
            val (vertices, faces) = elements.map { lines[it][2].toLong() }
            val expected = start + vertices * offsets.last() + faces * faceStride
            val size = file.size()
            if (size != expected) {
                fail(path, "byte $size", "has $size bytes, and with $faces triangles it would have $expected")
            }
            return SplitPly(
                file, format == "binary_big_endian", start, vertices, offsets.last(), places, faces, faceStride,
            )
        }
    }
}

/** Reads vertices: number, x, y, z. */
internal class PlyVertices(private val file: SplitPly) : RecordReader {
    override fun rows(range: ByteRange): Iterator<Row> {
        val bytes = file.read(range, file.vertexStride)
        return (0 until range.count).asSequence().map { number ->
            val at = number * file.vertexStride
            val (x, y, z) = file.places.map { bytes.getFloat(at + it) + 0f }
            RowFactory.create(range.first + number, x, y, z)
        }.iterator()
    }

    companion object {
        private const val serialVersionUID = 1L
        val SCHEMA: StructType = StructType().add("vertex", DataTypes.LongType, false)
            .add("x", DataTypes.FloatType, false).add("y", DataTypes.FloatType, false)
            .add("z", DataTypes.FloatType, false)
    }
}

/** Reads faces: index, and three numbers of vertices. */
internal class PlyFaces(private val file: SplitPly) : RecordReader {
    override fun rows(range: ByteRange): Iterator<Row> {
        val bytes = file.read(range, file.faceStride)
        return (0 until range.count).asSequence().map { number ->
            val at = number * file.faceStride
            val place = range.start + at
            if (bytes.get(at) != 3.toByte()) {
                SplitPly.fail(file.bytes.path, "byte $place", "the face has ${bytes.get(at)} corners, and not 3")
            }
            val (a, b, c) = List(3) { file.checked(bytes.getInt(at + 1 + 4 * it).toLong(), place) }
            RowFactory.create(range.first + number, a, b, c)
        }.iterator()
    }

    companion object {
        private const val serialVersionUID = 1L
        val SCHEMA: StructType = StructType().add("index", DataTypes.LongType, false)
            .add("v0", DataTypes.LongType, false).add("v1", DataTypes.LongType, false)
            .add("v2", DataTypes.LongType, false)
    }
}
