package dev.lazyz.spark.triangles.files

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.ply.PlyRecords
import java.io.Serializable
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

/**
 * A binary PLY file of which [PlyRecords] says where its vertices and faces are.
 *
 * @property places positions of x, y and z in a vertex
 */
internal class SplitPly private constructor(val bytes: SharedFile, records: PlyRecords) : Serializable {
    private val isBig = records.order == ByteOrder.BIG_ENDIAN
    private val start = records.start
    private val vertexCount = records.vertexCount.toLong()
    private val faceCount = records.faceCount.toLong()
    val vertexStride: Int = records.vertexBytes
    val places: IntArray = IntArray(3, records::positionOffset)
    private val end: Long get() = start + vertexCount * vertexStride + faceCount * PlyRecords.FACE_BYTES

    fun vertexRanges(partitionBytes: Long): List<ByteRange> =
        ByteRange.divide(start, vertexCount, vertexStride, partitionBytes)

    fun faceRanges(partitionBytes: Long): List<ByteRange> =
        ByteRange.divide(start + vertexCount * vertexStride, faceCount, PlyRecords.FACE_BYTES, partitionBytes)

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
        fun fail(path: String, place: String?, problem: String): Nothing = throw SceneFormatException(
            path, place, problem, "load it with Scenes.load, or convert it to binary PLY with plain triangles",
        )

        fun open(spark: SparkSession, path: String): SplitPly {
            val bytes = SharedFile.of(spark, path)
            val file = SplitPly(bytes, bytes.open { PlyRecords.read(it, path) })
            val size = bytes.size()
            if (size != file.end) {
                val problem = "has $size bytes, and with ${file.faceCount} triangles it would have ${file.end}"
                fail(path, "byte $size", problem)
            }
            return file
        }
    }
}

/** Reads vertices: number, x, y, z. */
internal class VertexRecords(private val file: SplitPly) : RecordReader {
    override fun rows(range: ByteRange): Iterator<Row> {
        val bytes = file.read(range, file.vertexStride)
        return (0 until range.count).asSequence().map { number ->
            val at = number * file.vertexStride
            val (x, y, z) = file.places.map { bytes.getFloat(at + it) + 0f }
            RowFactory.create(range.first + number, x, y, z)
        }.iterator()
    }

    companion object {
        val SCHEMA: StructType = StructType().add("vertex", DataTypes.LongType, false)
            .add("x", DataTypes.FloatType, false).add("y", DataTypes.FloatType, false)
            .add("z", DataTypes.FloatType, false)
    }
}

/** Reads faces: index, and three numbers of vertices. */
internal class FaceRecords(private val file: SplitPly) : RecordReader {
    override fun rows(range: ByteRange): Iterator<Row> {
        val bytes = file.read(range, PlyRecords.FACE_BYTES)
        return (0 until range.count).asSequence().map { number ->
            val at = number * PlyRecords.FACE_BYTES
            val place = range.start + at
            if (bytes.get(at) != 3.toByte()) {
                SplitPly.fail(file.bytes.path, "byte $place", "the face has ${bytes.get(at)} corners, and not 3")
            }
            val (a, b, c) = List(3) { file.checked(bytes.getInt(at + 1 + 4 * it).toLong(), place) }
            RowFactory.create(range.first + number, a, b, c)
        }.iterator()
    }

    companion object {
        val SCHEMA: StructType = StructType().add("index", DataTypes.LongType, false)
            .add("v0", DataTypes.LongType, false).add("v1", DataTypes.LongType, false)
            .add("v2", DataTypes.LongType, false)
    }
}
