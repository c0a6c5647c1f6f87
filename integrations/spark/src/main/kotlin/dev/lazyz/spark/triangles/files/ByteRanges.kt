package dev.lazyz.spark.triangles.files

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import java.io.IOException
import java.io.Serializable
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.apache.hadoop.fs.FSDataInputStream
import org.apache.hadoop.fs.Path
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.StructType
import org.apache.spark.util.SerializableConfiguration

/**
 * A file that all executors can read, through Hadoop's file systems.
 *
 * @property path a path or URI
 */
internal class SharedFile(val path: String, private val hadoop: SerializableConfiguration) : Serializable {
    private fun <T> reading(work: () -> T): T = try {
        work()
    } catch (e: SceneFormatException) {
        throw e
    } catch (e: IOException) {
        throw SceneReadException(path, "cannot be read: ${e.message ?: e}", "check the path", e)
    }

    /** Number of bytes. */
    fun size(): Long = reading { place().getFileSystem(hadoop.value()).getFileStatus(place()).len }

    /** Returns [count] bytes from [position] on, or up to the end of the file. */
    fun read(position: Long, count: Int, order: ByteOrder): ByteBuffer = open { input ->
        input.seek(position)
        val bytes = ByteArray(count)
        ByteBuffer.wrap(bytes, 0, input.readNBytes(bytes, 0, count)).order(order)
    }

    /** Passes the file to [read], at its beginning. */
    fun <T> open(read: (FSDataInputStream) -> T): T = reading {
        place().getFileSystem(hadoop.value()).open(place()).use(read)
    }

    private fun place() = Path(path)

    companion object {
        fun of(spark: SparkSession, path: String): SharedFile =
            SharedFile(path, SerializableConfiguration(spark.sparkContext().hadoopConfiguration()))
    }
}

/**
 * Records of equal length in a file.
 *
 * @property start position of the first record
 * @property first number of the first record
 */
internal class ByteRange(val start: Long, val first: Long, val count: Int) : Serializable {
    companion object {
        /** Returns ranges of at most [partitionBytes] of [count] records of [stride] bytes, which begin at [start]. */
        fun divide(start: Long, count: Long, stride: Int, partitionBytes: Long): List<ByteRange> {
            require(partitionBytes in 1..(1L shl 30)) { "partitionBytes must be in 1..2^30: $partitionBytes" }
            val each = (partitionBytes / stride).coerceAtLeast(1)
            return (0 until count step each).map { first ->
                ByteRange(start + first * stride, first, minOf(each, count - first).toInt())
            }
        }
    }
}

/** Makes rows of the records of a range. */
internal interface RecordReader : Serializable {
    fun rows(range: ByteRange): Iterator<Row>
}

internal object ByteRanges {
    /** Returns the rows of all [ranges], a partition for each. */
    fun read(spark: SparkSession, ranges: List<ByteRange>, reader: RecordReader, schema: StructType): Dataset<Row> {
        val context = JavaSparkContext.fromSparkContext(spark.sparkContext())
        val rows = context.parallelize(ranges, maxOf(ranges.size, 1)).flatMap { reader.rows(it) }
        return spark.createDataFrame(rows, schema)
    }
}
