package dev.lazyz.spark.triangles.files

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.nio.ByteOrder
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.SparkSession

/**
 * A binary STL file of [count] facets, of 50 bytes each after a header of 84.
 */
internal class SplitStl private constructor(val bytes: SharedFile, private val count: Long) {
    fun ranges(partitionBytes: Long): List<ByteRange> = ByteRange.divide(HEADER, count, FACET, partitionBytes)

    companion object {
        private const val HEADER = 84L
        const val FACET: Int = 50

        fun open(spark: SparkSession, path: String): SplitStl {
            val file = SharedFile.of(spark, path)
            val size = file.size()
            val head = file.read(0, HEADER.toInt(), ByteOrder.LITTLE_ENDIAN)
            if (head.limit() < HEADER) fail(path, "byte $size", "the file ends within the header of binary STL")
            val count = head.getInt(80).toLong() and 0xFFFFFFFFL
            val present = (size - HEADER) / FACET
            if (present < count) {
                fail(path, "byte $size", "the file ends within facet $present of the $count that byte 80 announces")
            }
            return SplitStl(file, count)
        }

        private fun fail(path: String, place: String, problem: String): Nothing = throw SceneFormatException(
            path, place, problem, "export the model again as binary STL; text files cannot be divided",
        )
    }
}

/** Reads facets as triangles. */
internal class StlFacets(private val file: SharedFile) : RecordReader {
    override fun rows(range: ByteRange): Iterator<Row> {
        val bytes = file.read(range.start, range.count * SplitStl.FACET, ByteOrder.LITTLE_ENDIAN)
        if (bytes.limit() < range.count * SplitStl.FACET) {
            throw SceneReadException(file.path, "has become shorter while it was read", "read it again")
        }
        return (0 until range.count).asSequence().map { number ->
            val at = number * SplitStl.FACET
            if (bytes.getShort(at + WORD) != 0.toShort()) {
                throw SceneFormatException(
                    file.path, "byte ${range.start + at + WORD}", "the facet has a colour, which tables do not have",
                    "set the attribute words to 0, or render it with DistributedPicture",
                )
            }
            // Adding 0 turns -0 into 0, as readers of whole files do
            val corners = Array<Any>(9) { bytes.getFloat(at + NORMAL + 4 * it) + 0f }
            RowFactory.create(range.first + number, *corners)
        }.iterator()
    }

    private companion object {
        /** Bytes of the normal, before the corners. */
        const val NORMAL = 12
        const val WORD = 48
    }
}
